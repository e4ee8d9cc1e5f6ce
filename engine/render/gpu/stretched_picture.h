// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/framebuffer.h"
#include "gl/texture.h"

namespace patina {

/// Represents a finished picture that stands in, stretched, for one of another size that is not
/// drawn yet. Used with one context current.
class StretchedPicture {
  public:
    explicit StretchedPicture(glm::ivec2 size);

    /// Returns where it is drawn.
    unsigned framebuffer() const { return kept_.name(); }

    /// Copies what a framebuffer of its size shows.
    void take(unsigned framebuffer);

    /// Fills a framebuffer of that size with it.
    void show(unsigned framebuffer, glm::ivec2 size) const;

  private:
    glm::ivec2 size_;
    gl::Texture image_;
    gl::Framebuffer kept_;
};

} // namespace patina
