// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/framebuffer.h"

namespace patina {

/// Does work of a known amount: it copies an image back and forth, scaled so that no driver can
/// skip it.
class TimerWork {
  public:
    TimerWork();

    /// Copies so many times; framebuffer 0 is bound afterwards.
    void run(int rounds) const;

  private:
    gl::Texture large_;
    gl::Texture small_;
    gl::Framebuffer largeFramebuffer_ = gl::Framebuffer::create();
    gl::Framebuffer smallFramebuffer_ = gl::Framebuffer::create();
};

} // namespace patina
