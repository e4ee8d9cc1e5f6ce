// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh.h"

namespace patina {

/// Names an edge by the indices of four vertices, as GL_LINES_ADJACENCY draws it: the opposite
/// corner of one face, the two ends, and the opposite corner of the other face. Both corners are
/// the same where the edge has one face, or more than two.
using MeshEdge = std::array<std::uint32_t, 4>;

/// Finds the edges of a mesh, each once. Vertices at the same place count as one, even if their
/// normals differ; triangles with two corners at one place are ignored. Works in steps, since a
/// million triangles take some tenths of a second.
class EdgeFinder {
  public:
    /// The mesh must stay as it is until all edges are found.
    explicit EdgeFinder(const MeshView& mesh);

    /// Works on about `items` more vertices or triangles. `mesh` is the one that the constructor
    /// was given.
    void proceed(const MeshView& mesh, std::size_t items);
    bool isDone() const { return triangle_ == triangles_; }

    std::span<const MeshEdge> edges() const { return edges_; }

  private:
    void joinVertex(const MeshView& mesh, std::uint32_t vertex);
    void addTriangle(const MeshView& mesh, std::size_t triangle);
    void addFace(std::uint32_t from, std::uint32_t to, std::uint32_t beside);

    std::vector<std::uint32_t> joined_; ///< has for each vertex the first one at the same place
    std::vector<std::uint32_t> vertexTable_; ///< is a hash table of 1 + the index of a vertex; 0
                                             ///< where free
    std::vector<std::uint32_t> edgeTable_;   ///< is a hash table of 1 + the index of an edge; 0
                                             ///< where free
    std::vector<MeshEdge> edges_;
    std::vector<std::uint8_t> faces_; ///< has for each edge its number of faces, at most 3
    std::size_t vertex_ = 0;          ///< is the next vertex to join
    std::size_t triangle_ = 0;        ///< is the next triangle to add
    std::size_t triangles_ = 0;
};

} // namespace patina
