// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

namespace patina {

/// Is a reflectance at normal incidence as other programs say it: the index of refraction with the
/// largest channel, and a tint.
struct DielectricIndex {
    double ior = 1.5;
    glm::dvec3 tint{1.0}; ///< above 1 where no index up to 40 is enough
};

DielectricIndex dielectricIndexOf(const glm::dvec3& f0);

} // namespace patina
