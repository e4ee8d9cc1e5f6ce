// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/polygon.h"

namespace patina {

/// A point where an outline crosses itself: shares of up to four points before it.
struct CrossingPoint {
    std::array<std::uint32_t, 4> points{};
    std::array<float, 4> shares{}; ///< their sum is 1
};

/// Triangles over a polygon's points, three indices each.
struct Tessellation {
    std::vector<std::uint32_t> triangles;
    std::vector<CrossingPoint> crossings; ///< the first one follows the corners
};

/// Covers what the outline runs around, however often, concave or not; corners on one line get no
/// triangle of their own where that can be avoided. Points where the outline crosses itself are
/// added to the polygon. Nothing for a polygon without a normal, or when GLU gives up.
std::optional<Tessellation> tessellate(Polygon& polygon);

} // namespace patina
