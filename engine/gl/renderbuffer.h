// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/name.h"

namespace patina::gl {

void deleteRenderbuffer(unsigned name);

/// Storage that is drawn to and never sampled.
class Renderbuffer {
  public:
    Renderbuffer() = default;

    /// `samples` 0 or 1 means one sample per pixel.
    static Renderbuffer create(glm::ivec2 size, unsigned internalFormat, int samples = 0);

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteRenderbuffer> name_;
};

} // namespace patina::gl
