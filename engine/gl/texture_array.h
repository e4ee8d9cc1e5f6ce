// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/texture.h"

namespace patina::gl {

/// Depths or colours in layers of one size, of one level, sampled as they are at texel centres.
class TextureArray {
  public:
    TextureArray() = default;

    /// `internalFormat` is a sized depth format; the content is undefined.
    static TextureArray create(glm::ivec2 size, int layers, unsigned internalFormat);

    /// Returns the same for a sized format of colours.
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
