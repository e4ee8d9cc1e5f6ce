// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h>

#include "gl/framebuffer.h"
#include "gl/vertex_array.h"

namespace patina::benchmarks {

/// Is a square target to draw to, bound as long as it lives.
class PixelTarget {
  public:
    explicit PixelTarget(int size)
        : color_(gl::Renderbuffer::create({size, size}, GL_RGBA16F, 0)) {
        framebuffer_.attachColor(color_);
        glViewport(0, 0, size, size);
        vertices_.bind();
    }

  private:
    gl::Renderbuffer color_;
    gl::Framebuffer framebuffer_ = gl::Framebuffer::create();
    gl::VertexArray vertices_ = gl::VertexArray::create();
};

} // namespace patina::benchmarks
