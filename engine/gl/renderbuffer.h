// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/name.h"

namespace patina::gl {

void deleteRenderbuffer(unsigned name);

/// Owns an image that is drawn to and never sampled.
class Renderbuffer {
  public:
    Renderbuffer() = default;

    /// Allocates undefined content. `size` is in pixels, `internalFormat` a sized GL format; 0 or 1
    /// `samples` mean one sample per pixel.
    static Renderbuffer create(glm::ivec2 size, unsigned internalFormat, int samples = 0);

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteRenderbuffer> name_;
};

} // namespace patina::gl
