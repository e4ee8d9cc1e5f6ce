// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace patina {

/// A file with more nodes inside nodes than this is damaged or made to harm.
constexpr int maxNodeDepth = 512;

/// Instancing can make gigabytes of a few bytes; 2^27 vertices are 1.5 GB of positions.
constexpr std::size_t maxVertices = std::size_t(1) << 27;

} // namespace patina
