// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/polygon.h"

namespace patina {

/// Describes a point where an outline crosses itself, as a weighted mean of up to four points that
/// precede it.
struct CrossingPoint {
    std::array<std::uint32_t, 4> points{};
    std::array<float, 4> shares{}; ///< their sum is 1
};

/// Holds triangles over a polygon's points, three indices each.
struct Tessellation {
    std::vector<std::uint32_t> triangles;
    /// The first crossing's index follows those of the corners.
    std::vector<CrossingPoint> crossings;
};

/// Covers everything that the outline winds around, concave or not; corners on one line get no
/// triangle of their own where that can be avoided. Points where the outline crosses itself are
/// added to the polygon. Returns nothing for a polygon without a normal, or when GLU fails.
std::optional<Tessellation> tessellate(Polygon& polygon);

} // namespace patina
