// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace patina {

/// Tells whether all three components are finite.
template <class Number>
bool isFinite(const glm::vec<3, Number>& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Returns the vector at length 1, and the null vector where it has no direction. The squares of
/// tiny and huge vectors leave the range of floats, so those are scaled first.
inline glm::vec3 unitOrZero(const glm::vec3& v) {
    const float square = glm::dot(v, v);
    if (square > 1e-30f && square < 1e30f) {
        return v / std::sqrt(square);
    }
    const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!isFinite(v) || largest == 0.0f) {
        return glm::vec3(0.0f);
    }
    const glm::vec3 scaled = v / largest;
    return scaled / std::sqrt(glm::dot(scaled, scaled));
}

} // namespace patina
