// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/framebuffer.h"
#include "gl/texture.h"

namespace patina {

/// What a framebuffer showed, while another takes its place: stretched, it stands in for a picture
/// of the new size that is not drawn yet. Used with one context current.
class LastPicture {
  public:
    /// Copies what a framebuffer of that size shows.
    LastPicture(unsigned framebuffer, glm::ivec2 size);

    /// Fills a framebuffer of that size with it.
    void show(unsigned framebuffer, glm::ivec2 size) const;

  private:
    glm::ivec2 size_;
    gl::Texture image_;
    gl::Framebuffer kept_;
};

} // namespace patina
