// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

#include "gl/name.h"

namespace patina::gl {

void deleteTexture(unsigned name);

/// Owns a two-dimensional texture of one level, sampled at texel centres.
class Texture {
  public:
    Texture() = default;

    /// Makes a texture that clamps at its edges and leaves it bound. `size` is in texels;
    /// `internalFormat` is a sized GL format; `format` and `type` say how `texels` lie in memory.
    /// Without `texels` the content is undefined.
    static Texture create(glm::ivec2 size, unsigned internalFormat, unsigned format, unsigned type,
                          const void* texels = nullptr);

    unsigned name() const { return name_.get(); }
    glm::ivec2 size() const { return size_; }

  private:
    Name<deleteTexture> name_;
    glm::ivec2 size_{0};
};

} // namespace patina::gl
