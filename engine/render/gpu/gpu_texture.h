// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/texture_picture.h"
#include "gl/name.h"
#include "gl/texture.h"

namespace patina {

/// Represents an image in the GPU's memory. Its small versions come first, and are shown until it
/// is whole.
class GpuTexture {
  public:
    /// Makes room for this picture. What is larger than the driver takes is left out. `isOpaque`:
    /// its alpha is 1 everywhere, whatever stands there.
    explicit GpuTexture(const TexturePicture& picture, bool isOpaque = false);

    /// Takes in about as many bytes more of the picture it was made for; at least those of its
    /// small versions. Gives the number of bytes. Binds the texture.
    std::size_t upload(const TexturePicture& picture, std::size_t bytes);
    bool isComplete() const { return level_ == first_ && row_ == 0; }

    void bind() const;

  private:
    void takeRows(const TexturePicture& picture, std::size_t level, int rows);
    void sendRows(const TexturePicture& picture, std::size_t level, int rows) const;

    gl::Name<gl::deleteTexture> name_;
    bool decodes_ = false;  ///< sRGB is decoded here, because the driver does it badly
    std::size_t first_ = 0; ///< level that is the largest here
    std::size_t level_ = 0; ///< the largest that is whole
    int row_ = 0;           ///< so many rows of the next larger one are there
};

} // namespace patina
