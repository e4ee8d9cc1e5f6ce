// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "gl/framebuffer.h"
#include "gl/vertex_array.h"
#include "shading/program/program_cache.h"

namespace patina {

/// The mean of several frames of one picture, as 32-bit floats.
class Accumulation {
  public:
    /// Makes its program, where it has none.
    Result<void> prepare(const Catalog& catalog, ProgramCache& cache);

    /// Prepares it and makes it fit; true when it did already, so that it may hold a mean.
    Result<bool> fit(glm::ivec2 size, const Catalog& catalog, ProgramCache& cache);

    /// Takes in a frame, which is `share` of the mean from now on: at 1 the only one.
    void add(const gl::Texture& frame, float share);

    const gl::Texture& mean() const { return mean_; }
    unsigned framebuffer() const { return framebuffer_.name(); }

    /// The shader files may have changed.
    void forget() { program_.reset(); }

  private:
    gl::Texture mean_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> program_;
};

} // namespace patina
