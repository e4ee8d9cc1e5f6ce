// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/mesh.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "render/instance_buffer.h"

namespace patina {

/// Some of a mesh's triangles, for some of the objects in an InstanceBuffer.
struct DrawRange {
    int firstTriangle = 0;
    int triangles = 0;
    std::size_t firstInstance = 0;
    std::size_t instances = 1;

    std::int64_t total() const { return std::int64_t(triangles) * std::int64_t(instances); }
};

/// A mesh in the GPU's memory. Attributes: 0 position, 1 normal, 2 tangent,
/// 3 texture coordinates, 4 on which side the bitangent is; then those of Instance.
class GpuMesh {
  public:
    /// Room for this mesh; upload() brings the content. `serial` tells it from every other one.
    explicit GpuMesh(const MeshView& mesh, std::uint64_t serial = 0);

    /// Takes in at most `bytes` more of the mesh it was made for, and at least one.
    void upload(const MeshView& mesh, std::size_t bytes);
    bool isComplete() const { return uploaded_ == vertices_.size() + indices_.size(); }

    /// Draws a complete mesh.
    void draw(const InstanceBuffer& instances, const DrawRange& range) const;
    /// Once, whole.
    void draw(const SingleInstance& instance) const { draw(instance.buffer(), {0, triangles_}); }
    int triangles() const { return triangles_; }
    std::uint64_t serial() const { return serial_; }

  private:
    /// How its vertices lie, and the instances of one buffer. Drivers take a vertex array that
    /// changes for another one, and may compile for it.
    struct Array {
        std::shared_ptr<const gl::Buffer> instances;
        std::size_t offset = 0;
        gl::VertexArray array;
    };

    Array& arrayFor(const InstanceBuffer& instances) const;
    gl::VertexArray makeArray() const;

    mutable std::vector<Array> arrays_; ///< by buffer; made when they are first drawn
    gl::Buffer vertices_ = gl::Buffer::create();
    gl::Buffer indices_ = gl::Buffer::create();
    std::size_t uploaded_ = 0; ///< bytes: of the vertices, then of the indices
    int triangles_ = 0;
    std::uint64_t serial_ = 0;
};

} // namespace patina
