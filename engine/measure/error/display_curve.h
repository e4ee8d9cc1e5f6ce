// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace patina {

/// Says how linear light becomes what a display shows: exposure, tone mapping and the sRGB curve,
/// in double precision, as passes/display.frag does it on the device.
struct DisplayCurve {
    double exposure = 0.0; ///< powers of two
    ToneMapping toneMapping = ToneMapping::KhronosNeutral;

    static DisplayCurve of(const Scene& scene) { return {scene.exposure, scene.toneMapping}; }

    /// Returns what the light is multiplied by.
    double factor() const;

    /// 0 .. 1 per channel, not rounded to steps.
    glm::dvec3 shown(const glm::dvec3& light) const;

    friend bool operator==(const DisplayCurve&, const DisplayCurve&) = default;
};

} // namespace patina
