// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// Represents an edge by the numbers of four vertices, as lines with adjacency are drawn: the
/// corner that one of its faces has beside it, its two ends, and the corner of the other face. Both
/// corners are the same where there is one face alone, or more than two.
using MeshEdge = std::array<std::uint32_t, 4>;

/// Finds the edges of a mesh, each once. Vertices at the same place are one, whatever else they
/// are; triangles without an area of which two corners are one vertex count for nothing. Works in
/// steps, since a million triangles take some tenths of a second.
class EdgeFinder {
  public:
    /// The mesh must stay as it is until all edges are found.
    explicit EdgeFinder(const MeshView& mesh);

    /// Looks at about `items` more vertices or triangles of it.
    void proceed(const MeshView& mesh, std::size_t items);
    bool isDone() const { return triangle_ == triangles_; }

    std::span<const MeshEdge> edges() const { return edges_; }

  private:
    void joinVertex(const MeshView& mesh, std::uint32_t vertex);
    void addTriangle(const MeshView& mesh, std::size_t triangle);
    void addFace(std::uint32_t from, std::uint32_t to, std::uint32_t beside);

    std::vector<std::uint32_t> joined_;     ///< by vertex: the first one at the same place
    std::vector<std::uint32_t> vertexTable_; ///< 1 + the number of a vertex; 0: free
    std::vector<std::uint32_t> edgeTable_;   ///< 1 + the number of an edge; 0: free
    std::vector<MeshEdge> edges_;
    std::vector<std::uint8_t> faces_; ///< by edge: how many it has, up to 3
    std::size_t vertex_ = 0;   ///< the next one
    std::size_t triangle_ = 0; ///< the next one
    std::size_t triangles_ = 0;
};

} // namespace patina
