// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace patina {

/// Returns a channel of light as a half-float image can hold it: finite, 0 .. 65504.
inline float storable(double channel) {
    return std::isfinite(channel) ? static_cast<float>(std::clamp(channel, 0.0, 65504.0)) : 0.0f;
}

/// Returns all channels as images can hold them; w is 0.
inline glm::vec4 storable(const glm::dvec3& light) {
    return {storable(light.x), storable(light.y), storable(light.z), 0.0f};
}

} // namespace patina
