// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/name.h"
#include "gl/texture.h"

namespace patina::gl {

/// Colours by direction: six square faces with all coarser levels, smooth between texels, levels
/// and faces.
class CubeMap {
  public:
    CubeMap() = default;

    /// `width` of a face is a power of two; `internalFormat` is a sized format of colours. The
    /// content is undefined.
    static CubeMap create(int width, unsigned internalFormat);

    /// Lets programs read these levels alone.
    void showLevels(int first, int last) const;

    void bind(unsigned unit) const;
    unsigned name() const { return name_.get(); }
    int width() const { return width_; }
    int levels() const { return levels_; }

  private:
    Name<deleteTexture> name_;
    int width_ = 0;
    int levels_ = 0;
};

} // namespace patina::gl
