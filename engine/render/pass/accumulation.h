// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "gl/framebuffer.h"
#include "gl/vertex_array.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Owns the mean of several frames of one picture, as 32-bit floats.
class Accumulation {
  public:
    /// Makes the program of add() unless it is there; the error is a message of the compiler.
    Result<void> prepare(const Catalog& catalog, ProgramCache& cache);

    /// Does prepare() and fits the image to `size`, in pixels. Returns true when it had that size
    /// already, so that its mean is still there.
    Result<bool> fit(glm::ivec2 size, const Catalog& catalog, ProgramCache& cache);

    /// Blends a frame into the mean with the weight `share`; 1 replaces the mean.
    void add(const gl::Texture& frame, float share);

    const gl::Texture& mean() const { return mean_; }
    unsigned framebuffer() const { return framebuffer_.name(); }

    /// Drops the program, because the shader files may have changed.
    void forget() { program_.reset(); }

  private:
    gl::Texture mean_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> program_;
};

} // namespace patina
