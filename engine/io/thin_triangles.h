// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "io/polygon.h"

namespace patina {

/// Cuts a triangle whose corners lie on one line, and its neighbour at the longest side, along the
/// other diagonal. Left alone, it would be nothing to draw, and its middle corner a gap in the edge
/// of the neighbour.
void turnThinTriangles(const Polygon& polygon, std::vector<std::uint32_t>& triangles);

} // namespace patina
