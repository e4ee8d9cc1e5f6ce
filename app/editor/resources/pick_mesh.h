// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// Is the number of consecutive triangles that share one box in runBoundsOf().
inline constexpr std::size_t trianglesPerRun = 128;

/// Returns the boxes around each run of triangles. Neighbours in a well-ordered mesh are close in
/// space, so that a ray meets few of the boxes.
std::vector<Bounds> runBoundsOf(const MeshView& mesh);

/// Holds a mesh for ray tests, with the boxes around its runs; without boxes each triangle is
/// tested.
struct PickMesh {
    PickMesh() = default;
    PickMesh(const MeshView& triangles, std::span<const Bounds> boxes = {})
        : mesh(triangles), runs(boxes) {}

    MeshView mesh;
    std::span<const Bounds> runs;
};

} // namespace patina
