// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "core/mesh.h"

namespace patina {

/// Says how a surface bends at a vertex, as the GPU reads it: 24 bytes. Where one goes by x on the
/// surface its unit normal changes by S x, in object space and per metre; S is symmetric and has
/// nothing along the normal. Its directions in the surface are the principal ones.
struct VertexCurvature {
    glm::vec3 diagonal{0.0f}; ///< is xx, yy, zz
    glm::vec3 mixed{0.0f};    ///< is xy, yz, zx

    friend bool operator==(const VertexCurvature&, const VertexCurvature&) = default;
};

/// Finds how a mesh bends at each vertex: the mean, by area, of what the normals at the corners of
/// the triangles around say (S. Rusinkiewicz, Estimating Curvatures and Their Derivatives on
/// Triangle Meshes, 3DPVT 2004), and then twice of the vertices around, so that the directions of
/// coarse or noisy meshes go over into each other. What has no area or is not finite counts as
/// flat. The same mesh gives the same curvatures, however the work is cut into steps. Takes 56
/// bytes for each vertex.
class CurvatureFinder {
  public:
    /// The mesh must stay as it is.
    explicit CurvatureFinder(const MeshView& mesh);

    /// Works on about `items` more triangles or vertices.
    void proceed(const MeshView& mesh, std::size_t items);

    bool isDone() const { return pass_ == passes; }
    const std::vector<VertexCurvature>& curvatures() const { return found_; }

  private:
    static constexpr int smoothings = 2;
    static constexpr int passes = 2 * (1 + smoothings); ///< over triangles, then over vertices

    struct Sum {
        VertexCurvature curvature;
        float weight = 0.0f;
    };

    void addTriangle(const MeshView& mesh, std::size_t triangle);
    void addNeighbours(const MeshView& mesh, std::size_t triangle);
    void finishVertex(const MeshView& mesh, std::size_t vertex);

    std::vector<VertexCurvature> found_;
    std::vector<Sum> sums_;
    int pass_ = 0;
    std::size_t next_ = 0; ///< is the triangle or vertex that is next
};

} // namespace patina
