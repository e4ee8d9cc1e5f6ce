// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/mesh.h"
#include "gl/buffer.h"
#include "render/gpu/instanced_arrays.h"

namespace patina {

class EdgeFinder;

/// Holds the edges of a mesh in the GPU's memory: four numbers of vertices each, as lines with
/// adjacency (MeshEdge), 16 bytes for an edge.
class GpuEdges {
  public:
    explicit GpuEdges(const MeshView& mesh);
    ~GpuEdges();
    GpuEdges(GpuEdges&&) noexcept;
    GpuEdges& operator=(GpuEdges&&) noexcept;

    /// Some milliseconds of what there is to do before they can be drawn.
    void proceed(const MeshView& mesh);
    bool isComplete() const { return finder_ == nullptr; }

    /// Returns how many edges there are, once they are complete.
    int count() const { return static_cast<int>(indices_.size() / bytesPerEdge); }

    /// Draws complete ones; a range counts edges as triangles.
    void draw(const gl::Buffer& vertices, const InstanceBuffer& instances,
              const DrawRange& range) const;

  private:
    static constexpr std::size_t bytesPerEdge = 16;

    gl::VertexArray makeArray(const gl::Buffer& vertices) const;

    std::unique_ptr<EdgeFinder> finder_; ///< until all are in the GPU's memory
    gl::Buffer indices_ = gl::Buffer::create();
    std::size_t uploaded_ = 0; ///< bytes
    mutable InstancedArrays arrays_;
};

} // namespace patina
