// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "core/mesh.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"
#include "render/gpu/gpu_edges.h"
#include "render/gpu/instanced_arrays.h"

namespace patina {

/// Represents a mesh in the GPU's memory. Attributes: 0 position, 1 normal, 2 tangent, 3 texture
/// coordinates, 4 on which side the bitangent is; then those of Instance; 11 openness, once it is
/// there: without it nothing is hidden.
class GpuMesh {
  public:
    /// Makes room for this mesh; upload() brings the content. `serial` tells it from every other
    /// one.
    explicit GpuMesh(const MeshView& mesh, std::uint64_t serial = 0);

    /// Takes in at most `bytes` more of the mesh it was made for, and at least one.
    void upload(const MeshView& mesh, std::size_t bytes);
    bool isComplete() const { return uploaded_ == vertices_.size() + indices_.size(); }

    /// Takes in the openness of the mesh it was made for, where that is there and new.
    void takeOpenness(const MeshView& mesh);

    /// Draws a complete mesh.
    void draw(const InstanceBuffer& instances, const DrawRange& range) const;
    /// Draws all of it once.
    void draw(const SingleInstance& instance) const { draw(instance.buffer(), {0, triangles_}); }
    int triangles() const { return triangles_; }
    std::uint64_t serial() const { return serial_; }

    /// Its edges, which may not be there yet: for the frame of this number, after which they are
    /// kept for a while.
    GpuEdges& edges(const MeshView& mesh, std::uint64_t frame);
    void drawEdges(const InstanceBuffer& instances, const DrawRange& range) const {
        edges_->draw(vertices_, instances, range);
    }
    bool hasEdges() const { return edges_ && edges_->isComplete(); }
    int edgeCount() const { return edges_->count(); }

    /// Forgets edges that no frame since this one has asked for.
    void forgetEdges(std::uint64_t frame);

  private:
    gl::VertexArray makeArray() const;

    mutable InstancedArrays arrays_;
    gl::Buffer vertices_ = gl::Buffer::create();
    gl::Buffer indices_ = gl::Buffer::create();
    std::optional<gl::Buffer> openness_;
    std::size_t uploaded_ = 0; ///< bytes: of the vertices, then of the indices
    int triangles_ = 0;
    std::uint64_t serial_ = 0;
    std::optional<GpuEdges> edges_;
    std::uint64_t edgesFrame_ = 0; ///< the last one that asked for them
};

} // namespace patina
