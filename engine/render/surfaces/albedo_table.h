// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/framebuffer.h"
#include "gl/vertex_array.h"
#include "render/gpu/pipeline.h"

namespace patina {

/// Holds a model's albedo for each direction of view, in a texture on the GPU.
class AlbedoTable {
  public:
    /// Fills the table with a pipeline of SurfaceOutput::AlbedoTable, from the object data that is
    /// bound.
    void fill(const Pipeline& pipeline);

    /// Binds the table to texture unit 0, for the program's only sampler. A table that was never
    /// filled is black.
    void bind() const;

    const Pipeline* filledWith() const { return pipeline_; }
    void forget() { pipeline_ = nullptr; }

  private:
    const Pipeline* pipeline_ = nullptr;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    gl::Texture texture_;
    gl::Framebuffer framebuffer_;
};

} // namespace patina
