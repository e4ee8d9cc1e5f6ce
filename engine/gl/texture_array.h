// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/texture.h"

namespace patina::gl {

/// Owns an array texture of depths or colours with one level, sampled at texel centres.
class TextureArray {
  public:
    TextureArray() = default;

    /// Allocates layers of depths with undefined content. `size` is in texels; `internalFormat` is
    /// a sized depth format.
    static TextureArray create(glm::ivec2 size, int layers, unsigned internalFormat);

    /// Does the same for colours; `internalFormat` is a sized colour format.
    static TextureArray createColors(glm::ivec2 size, int layers, unsigned internalFormat);

    unsigned name() const { return name_.get(); }
    glm::ivec2 size() const { return size_; }
    int layers() const { return layers_; }

  private:
    static TextureArray create(glm::ivec2 size, int layers, unsigned internalFormat,
                               unsigned format);

    Name<deleteTexture> name_;
    glm::ivec2 size_{0};
    int layers_ = 0;
};

} // namespace patina::gl
