// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/mesh.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"

namespace patina {

/// A mesh in the GPU's memory. Attributes: 0 position, 1 normal, 2 tangent,
/// 3 texture coordinates, 4 on which side the bitangent is.
class GpuMesh {
  public:
    /// Room for this mesh; upload() brings the content. `serial` tells it from every other one.
    explicit GpuMesh(const MeshView& mesh, std::uint64_t serial = 0);

    /// Takes in at most `bytes` more of the mesh it was made for, and at least one.
    void upload(const MeshView& mesh, std::size_t bytes);
    bool isComplete() const { return uploaded_ == vertices_.size() + indices_.size(); }

    /// Draws some of the triangles of a complete mesh.
    void draw(int first, int count) const;
    void draw() const { draw(0, triangles_); }
    int triangles() const { return triangles_; }
    std::uint64_t serial() const { return serial_; }

  private:
    gl::VertexArray array_ = gl::VertexArray::create();
    gl::Buffer vertices_ = gl::Buffer::create();
    gl::Buffer indices_ = gl::Buffer::create();
    std::size_t uploaded_ = 0; ///< bytes: of the vertices, then of the indices
    int triangles_ = 0;
    std::uint64_t serial_ = 0;
};

} // namespace patina
