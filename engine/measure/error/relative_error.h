// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

namespace patina {

/// Is the light of half an 8-bit step on a display, after exposure. The sRGB curve is a straight
/// line there.
inline constexpr double minShownLight = 0.5 / 255.0 / 12.92;

inline double greatestOf(const glm::dvec3& v) {
    return std::max({v.x, v.y, v.z});
}

/// Returns the relative error of a colour: the largest error of a channel over the brightest
/// channel of the right colour, or over `floor` where that is brighter. It is infinite for NaN.
inline double relativeError(const glm::dvec3& right, const glm::dvec3& got, double floor) {
    const glm::dvec3 off = glm::abs(got - right);
    if (std::isnan(off.x + off.y + off.z)) {
        return std::numeric_limits<double>::infinity();
    }
    return greatestOf(off) / std::max(greatestOf(right), floor);
}

} // namespace patina
