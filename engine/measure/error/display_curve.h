// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "catalog/catalog.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace patina {

/// Converts linear light to display values by exposure, tone curve and the sRGB curve, in double
/// precision, as passes/display.frag does on the device.
struct DisplayCurve {
    double exposure = 0.0;                  ///< EV, powers of two
    const reference::Block* tone = nullptr; ///< is null where there is none
    std::vector<double> values{};           ///< are the packed values of the tone curve

    /// Returns the curve of a scene. A tone curve without code in double precision, which was added
    /// since the program was built, counts as none.
    static DisplayCurve of(const Scene& scene, const Catalog& catalog);

    /// Returns display values 0 .. 1, not rounded to 8 bits.
    glm::dvec3 shown(const glm::dvec3& light) const;
};

} // namespace patina
