// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "render/gpu/instance_buffer.h"

namespace patina {

/// Says which part of what a mesh is made of (triangles, or its edges), for some of the objects in
/// an InstanceBuffer.
struct DrawRange {
    int firstTriangle = 0;
    int triangles = 0;
    std::size_t firstInstance = 0;
    std::size_t instances = 1;

    std::int64_t total() const { return std::int64_t(triangles) * std::int64_t(instances); }
};

/// Tells how the vertices of a mesh lie, together with the instances of one buffer or of several.
/// Drivers take a vertex array that changes for another one, and may compile for it.
class InstancedArrays {
  public:
    /// Makes an array that has the vertices and the indices.
    using Make = std::function<gl::VertexArray()>;

    /// Draws primitives of `corners` indices each, from where the range begins.
    void draw(unsigned mode, int corners, const InstanceBuffer& instances, const DrawRange& range,
              const Make& make);

  private:
    struct Array {
        std::shared_ptr<const gl::Buffer> instances;
        std::size_t offset = 0;
        gl::VertexArray array;
    };

    Array& arrayFor(const InstanceBuffer& instances, const Make& make);

    std::vector<Array> arrays_; ///< by buffer; made when they are first drawn
};

} // namespace patina
