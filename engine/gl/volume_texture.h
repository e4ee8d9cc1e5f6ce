// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "gl/texture.h"

namespace patina::gl {

/// Owns a three-dimensional texture of one level, sampled at texel centres.
class VolumeTexture {
  public:
    VolumeTexture() = default;

    /// Makes a texture of three floats per texel, x quickest, that clamps at its edges. `size` is
    /// in texels.
    static VolumeTexture create(const glm::ivec3& size, const float* texels);

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteTexture> name_;
};

} // namespace patina::gl
