// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/geometric.hpp>

#include "catalog/parameter.h"

namespace patina {

inline bool isDirection(const Parameter& parameter) {
    return parameter.space == Space::WorldDirection || parameter.space == Space::CameraDirection;
}

/// Returns a direction as blocks see it, of length 1; straight down where it has no length.
inline glm::dvec3 unitDirection(const glm::dvec3& value) {
    const double length = glm::length(value);
    return length > 1e-15 ? value / length : glm::dvec3(0.0, -1.0, 0.0);
}

} // namespace patina
