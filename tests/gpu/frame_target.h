// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <epoxy/gl.h>

#include "gl/framebuffer.h"

namespace patina {

/// Is a square that frames are shown in, as in a window. It is made, used and destroyed with one
/// context current.
class FrameTarget {
  public:
    explicit FrameTarget(int side)
        : side_(side),
          color_(gl::Texture::create({side, side}, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE)),
          target_(gl::Framebuffer::create()) {
        target_.attachColor(color_);
    }

    unsigned name() const { return target_.name(); }

    /// Returns red, green, blue and alpha of every pixel, rows from the bottom.
    std::vector<std::uint8_t> picture() const {
        std::vector<std::uint8_t> bytes(std::size_t(4) * std::size_t(side_) * std::size_t(side_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.name());
        glReadPixels(0, 0, side_, side_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        return bytes;
    }

  private:
    int side_;
    gl::Texture color_;
    gl::Framebuffer target_;
};

} // namespace patina
