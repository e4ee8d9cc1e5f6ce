// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/texture_picture.h"
#include "gl/name.h"
#include "gl/texture.h"

namespace patina {

/// Holds an image in the GPU's memory. Its small mip levels are uploaded first and shown until the
/// larger ones are complete.
class GpuTexture {
  public:
    /// Allocates the levels of this picture, without those that are too large for the driver. If
    /// `isOpaque`, shaders read an alpha of 1 everywhere.
    explicit GpuTexture(const TexturePicture& picture, bool isOpaque = false);

    /// Uploads about `bytes` more of the picture that it was made for, at least its small levels,
    /// and returns how many bytes that were. Leaves the texture bound.
    std::size_t upload(const TexturePicture& picture, std::size_t bytes);
    bool isComplete() const { return level_ == first_ && row_ == 0; }

    void bind() const;

  private:
    void takeRows(const TexturePicture& picture, std::size_t level, int rows);
    void sendRows(const TexturePicture& picture, std::size_t level, int rows) const;

    gl::Name<gl::deleteTexture> name_;
    bool decodes_ = false;  ///< is true where sRGB is decoded on the CPU, because the driver does
                            ///< it inexactly
    std::size_t first_ = 0; ///< is the largest level of the picture that the driver takes
    std::size_t level_ = 0; ///< is the largest level that is complete
    int row_ = 0;           ///< is how many rows of the next larger level are uploaded
};

} // namespace patina
