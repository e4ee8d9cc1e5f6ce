// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace patina {

/// Limits how deep nodes are nested: a file with more levels is damaged or made to harm.
constexpr int maxNodeDepth = 512;

/// Limits the vertices of a mesh, since instancing can make gigabytes of a few bytes; 2^27 vertices
/// are 1.5 GB of positions.
constexpr std::size_t maxVertices = std::size_t(1) << 27;

} // namespace patina
