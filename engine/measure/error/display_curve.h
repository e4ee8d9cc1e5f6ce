// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "catalog/catalog.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace patina {

/// Says how linear light becomes what a display shows: exposure, tone curve and the sRGB curve, in
/// double precision, as passes/display.frag does it on the device.
struct DisplayCurve {
    double exposure = 0.0;                  ///< powers of two
    const reference::Block* tone = nullptr; ///< null: none
    std::vector<double> values{};           ///< of the tone curve

    /// A curve without code in double precision, which was added since the program was
    /// built, counts as none.
    static DisplayCurve of(const Scene& scene, const Catalog& catalog);

    /// Returns what the scene's light is multiplied by.
    static double factor(double exposure);

    /// Returns 0 .. 1 per channel, not rounded to steps.
    glm::dvec3 shown(const glm::dvec3& light) const;
};

} // namespace patina
