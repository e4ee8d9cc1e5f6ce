// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh.h"
#include "core/progress.h"

namespace patina {

/// Says what a vertex sees past its mesh.
struct Openness {
    /// Is the unoccluded share of light from everywhere, weighted by the cosine: 0 .. 1.
    float share = 1.0f;
    glm::vec3 direction{0.0f}; ///< is the mean of the unoccluded directions, unit
    float back = 1.0f;         ///< is the same share for the other side of the surface, 0 .. 1
};

/// Decodes a vertex' eight bytes. `normal` is the vertex' own.
Openness unpacked(const VertexOpenness& packed, const glm::vec3& normal);

/// Finds for each vertex how much of its surroundings its own mesh leaves free, by rays, on all
/// cores but one. Large meshes have fewer rays per vertex, so that it takes a bounded time: half a
/// minute of one core for a million triangles. Where a vertex or all of a mesh has no extent, no
/// normal or values that are not finite, nothing is hidden. The result is empty when the work was
/// cancelled.
std::vector<VertexOpenness> opennessOf(const MeshView& mesh, Progress* progress = nullptr);

} // namespace patina
