// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace patina {

/// Light of half an 8-bit step on a display, with the exposure in it: where the sRGB curve is a
/// straight line.
inline constexpr double minShownLight = 0.5 / 255.0 / 12.92;

inline double greatestOf(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// Returns how far a colour is from the right one: the channel that is off by most, relative to the
/// brightest channel, or to `floor` where that is darker. What is not a number is infinitely wrong.
inline double relativeError(const glm::dvec3& right, const glm::dvec3& got, double floor) {
    const glm::dvec3 off = glm::abs(got - right);
    if (std::isnan(off.x + off.y + off.z)) {
        return std::numeric_limits<double>::infinity();
    }
    return greatestOf(off) / std::max(greatestOf(right), floor);
}

} // namespace patina
