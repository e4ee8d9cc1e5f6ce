// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/name.h"
#include "gl/texture.h"

namespace patina::gl {

/// Owns an image that is drawn to and then read texel by texel, with one or several samples per
/// pixel.
class TargetTexture {
  public:
    TargetTexture() = default;

    /// Allocates undefined content. `size` is in pixels; `internalFormat` is a sized format of
    /// colours, or GL_DEPTH_COMPONENT32F. The samples lie where those of a renderbuffer do.
    static TargetTexture create(glm::ivec2 size, unsigned internalFormat, int samples);

    /// Allocates the same with one sample and the levels up to `lastLevel`, each half as large as
    /// the one before it.
    static TargetTexture createLevels(glm::ivec2 size, unsigned internalFormat, int lastLevel);

    /// Lets programs read the levels up to this one, so that another may be drawn to.
    void showLevels(int lastLevel) const;

    unsigned name() const { return name_.get(); }

    /// Returns GL_TEXTURE_2D, or GL_TEXTURE_2D_MULTISAMPLE where there are several samples.
    unsigned target() const { return target_; }

    void bind(unsigned unit) const;

  private:
    Name<deleteTexture> name_;
    unsigned target_ = 0;
};

} // namespace patina::gl
