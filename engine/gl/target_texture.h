// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/name.h"
#include "gl/texture.h"

namespace patina::gl {

/// An image to draw into and to read texel by texel, of one or of several samples per pixel.
class TargetTexture {
  public:
    TargetTexture() = default;

    /// `internalFormat` is a sized format of colours, or of depths alone. The samples lie where
    /// those of a renderbuffer do. The content is undefined.
    static TargetTexture create(glm::ivec2 size, unsigned internalFormat, int samples);

    unsigned name() const { return name_.get(); }

    /// GL_TEXTURE_2D, or GL_TEXTURE_2D_MULTISAMPLE where there are several samples.
    unsigned target() const { return target_; }

    /// Binds it to a texture unit.
    void bind(unsigned unit) const;

  private:
    Name<deleteTexture> name_;
    unsigned target_ = 0;
};

} // namespace patina::gl
