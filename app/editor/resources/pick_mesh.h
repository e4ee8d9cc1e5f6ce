// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// So many triangles that follow each other have one box in runBoundsOf.
inline constexpr std::size_t trianglesPerRun = 128;

/// The boxes around each run of triangles. Neighbours in a well-ordered mesh are neighbours in
/// space, so a ray meets few of them.
std::vector<Bounds> runBoundsOf(const MeshView& mesh);

/// A mesh for rays: with the boxes around its runs, or without where it is small.
struct PickMesh {
    PickMesh() = default;
    PickMesh(const MeshView& triangles, std::span<const Bounds> boxes = {})
        : mesh(triangles), runs(boxes) {}

    MeshView mesh;
    std::span<const Bounds> runs;
};

} // namespace patina
