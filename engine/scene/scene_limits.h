// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "catalog/json_text.h"

namespace patina {

/// Limits a scene's file, which holds the complete material of each object: about two kilobytes
/// each.
inline constexpr JsonLimits sceneLimits{.bytes = std::size_t(256) << 20};

// These limits of a scene's numbers keep products of them from overflowing a float: metres and
// degrees, factors, linear light.
inline constexpr double farthest = 1e6;
inline constexpr double largestScale = 1e6;
inline constexpr double smallestScale = 1e-6f; // numbers of files are floats
inline constexpr double brightest = 1e6;

/// Returns the nearest factors that neither flatten an object nor let its corners overflow.
inline glm::dvec3 usableScale(const glm::dvec3& scale) {
    const auto usable = [](double factor) {
        return std::copysign(std::clamp(std::abs(factor), smallestScale, largestScale), factor);
    };
    return {usable(scale.x), usable(scale.y), usable(scale.z)};
}

} // namespace patina
