// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "catalog/json_text.h"

namespace patina {

/// A scene holds the whole material of each of its objects: some two kilobytes for each.
inline constexpr JsonLimits sceneLimits{.bytes = std::size_t(256) << 20};

// What a scene may hold, so that no product of such numbers overflows a float on the way to the
// screen: metres and degrees, factors, linear light.
inline constexpr double farthest = 1e6;
inline constexpr double largestScale = 1e6;
inline constexpr double smallestScale = 1e-6f; // numbers of files are floats
inline constexpr double brightest = 1e6;
inline constexpr double maxStops = 32.0; ///< of exposure, either way

/// Returns the nearest factors that neither flatten an object nor let its corners overflow.
inline glm::dvec3 usableScale(const glm::dvec3& scale) {
    const auto usable = [](double factor) {
        return std::copysign(std::clamp(std::abs(factor), smallestScale, largestScale), factor);
    };
    return {usable(scale.x), usable(scale.y), usable(scale.z)};
}

} // namespace patina
