// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Defines how an image lies in a shared block: a 32-byte header, then the floats.
class ImageBlock {
  public:
    /// Returns the block's size in bytes; 0 for an impossible image (no pixels, a number of
    /// channels other than 1, 3 or 4, or more than 1 GiB).
    static std::size_t sizeFor(int width, int height, int channels);

    /// Writes the image into a block of sizeFor(...) bytes. `bits` is FileImage::bits.
    static void write(std::span<std::byte> block, const Image& image, int bits = 0);

    /// Copies the image that another process wrote. Fails when the header or the block's length is
    /// wrong.
    static Result<Image> checked(std::span<const std::byte> block);

    /// Returns FileImage::bits of a block that checked() accepted.
    static int bits(std::span<const std::byte> block);
};

} // namespace patina
