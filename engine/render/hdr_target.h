// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "core/error.h"
#include "gl/framebuffer.h"

namespace patina {

/// Where a frame is summed up: RGBA16F with MSAA and depth, and its resolved image.
class HdrTarget {
  public:
    /// Makes the target fit; nothing happens when it does already. Fewer samples are used where
    /// the driver offers fewer. The error says which sizes are possible.
    Result<void> fit(glm::ivec2 size, int samples);

    /// Binds it for drawing, with its whole area as the viewport.
    void bind() const;

    /// Averages the samples into the resolved image.
    void resolve() const;

    const gl::Texture& resolved() const { return resolvedImage_; }
    unsigned resolvedFramebuffer() const { return resolvedFramebuffer_.name(); }

  private:
    Result<void> build(glm::ivec2 size, int samples);

    glm::ivec2 size_{0};
    int samples_ = 0;
    gl::Renderbuffer color_;
    gl::Renderbuffer depth_;
    gl::Framebuffer framebuffer_;
    gl::Texture resolvedImage_;
    gl::Framebuffer resolvedFramebuffer_;
};

} // namespace patina
