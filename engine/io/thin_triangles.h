// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "io/polygon.h"

namespace patina {

/// Swaps the edge between a triangle whose corners lie on one line and its neighbour at the longest
/// side. Otherwise nothing of that triangle would be drawn, and its middle corner would leave a gap
/// in the edge of the neighbour.
void turnThinTriangles(const Polygon& polygon, std::vector<std::uint32_t>& triangles);

} // namespace patina
