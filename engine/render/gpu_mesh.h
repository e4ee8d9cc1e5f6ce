// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"

namespace patina {

/// A mesh in the GPU's memory. Attributes: 0 position, 1 normal, 2 tangent.
class GpuMesh {
  public:
    explicit GpuMesh(const MeshView& mesh);

    void draw() const;
    int triangles() const { return count_ / 3; }

  private:
    gl::VertexArray array_ = gl::VertexArray::create();
    gl::Buffer vertices_ = gl::Buffer::create();
    gl::Buffer indices_ = gl::Buffer::create();
    int count_ = 0;
};

} // namespace patina
