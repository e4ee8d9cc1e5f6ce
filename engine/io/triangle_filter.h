// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "io/raw_mesh.h"

namespace patina {

/// Counts the triangles that were removed, each by the first reason that holds.
struct UselessTriangles {
    std::size_t notFinite = 0; ///< a corner is at NaN or infinity
    std::size_t tooFar = 0;    ///< a corner is beyond 1e15
    std::size_t noArea = 0;

    std::size_t all() const { return notFinite + tooFar + noArea; }

    /// Returns what was wrong with them: "no area or no finite position".
    std::string reasons() const;
};

/// Removes triangles that cannot be drawn.
UselessTriangles dropUselessTriangles(RawMesh& mesh);

} // namespace patina
