// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/mesh_curvature.h"
#include "gl/buffer.h"
#include "gl/vertex_array.h"

namespace patina {

/// Holds how a mesh bends at its vertices in the GPU's memory, 24 bytes each.
class GpuCurvature {
  public:
    explicit GpuCurvature(const MeshView& mesh);

    /// Finds some more, which takes some milliseconds, or uploads them. It is called until
    /// isComplete().
    void proceed(const MeshView& mesh);
    bool isComplete() const { return finder_ == nullptr; }

    /// Has a vertex array read what is complete as passes/drawn_curvature.vert does.
    void readBy(gl::VertexArray& array) const;

  private:
    std::unique_ptr<CurvatureFinder> finder_; ///< is null once all is in the GPU's memory
    gl::Buffer buffer_ = gl::Buffer::create();
};

} // namespace patina
