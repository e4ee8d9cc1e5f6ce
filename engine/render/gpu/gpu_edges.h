// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "core/mesh.h"
#include "gl/buffer.h"
#include "render/gpu/instanced_arrays.h"

namespace patina {

class EdgeFinder;

/// Holds the edges of a mesh in the GPU's memory as lines with adjacency (MeshEdge); an edge takes
/// 16 bytes.
class GpuEdges {
  public:
    explicit GpuEdges(const MeshView& mesh);
    ~GpuEdges();
    GpuEdges(GpuEdges&&) noexcept;
    GpuEdges& operator=(GpuEdges&&) noexcept;

    /// Finds or uploads some more edges, which takes some milliseconds. It is called until
    /// isComplete().
    void proceed(const MeshView& mesh);
    bool isComplete() const { return finder_ == nullptr; }

    /// Returns how many edges there are, once they are complete.
    int count() const { return static_cast<int>(indices_.size() / bytesPerEdge); }

    /// Draws edges that are complete, of vertices that are white without `colors`; `range` counts
    /// edges where it says triangles.
    void draw(const gl::Buffer& vertices, const gl::Buffer* colors, const InstanceBuffer& instances,
              const DrawRange& range) const;

  private:
    static constexpr std::size_t bytesPerEdge = 16;

    gl::VertexArray makeArray(const gl::Buffer& vertices, const gl::Buffer* colors) const;

    std::unique_ptr<EdgeFinder> finder_; ///< is null once all are in the GPU's memory
    gl::Buffer indices_ = gl::Buffer::create();
    std::size_t uploaded_ = 0; ///< bytes
    mutable InstancedArrays arrays_;
};

} // namespace patina
