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

/// Selects some triangles (or edges) of a mesh and some of the objects in an InstanceBuffer.
struct DrawRange {
    int firstTriangle = 0;
    int triangles = 0;
    std::size_t firstInstance = 0;
    std::size_t instances = 1;
    int copies = 1; ///< is how many instances each object is drawn as, one after the other

    std::int64_t total() const {
        return std::int64_t(triangles) * std::int64_t(instances) * copies;
    }
};

/// Keeps a vertex array of a mesh for each buffer of instances. A driver may compile again for a
/// vertex array that changes, so none is shared between buffers.
class InstancedArrays {
  public:
    /// Makes a vertex array with the mesh's vertices and indices, without instances.
    using Make = std::function<gl::VertexArray()>;

    /// Draws the primitives of a range, of GL mode `mode` with `corners` indices each.
    void draw(unsigned mode, int corners, const InstanceBuffer& instances, const DrawRange& range,
              const Make& make);

  private:
    struct Array {
        std::shared_ptr<const gl::Buffer> instances;
        std::size_t offset = 0;
        int copies = 1;
        gl::VertexArray array;
    };

    Array& arrayFor(const InstanceBuffer& instances, const Make& make);

    std::vector<Array> arrays_; ///< has one for each buffer, made when it is first drawn
};

} // namespace patina
