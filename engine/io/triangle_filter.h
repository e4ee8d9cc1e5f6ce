// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "io/raw_mesh.h"

namespace patina {

/// Removes triangles that cannot be drawn: a corner that is not finite or beyond 1e15, or no
/// area. Gives their number.
std::size_t dropUselessTriangles(RawMesh& mesh);

} // namespace patina
