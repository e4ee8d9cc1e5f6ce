// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Tells how an image lies in a shared block: a 32-byte header, then the floats.
class ImageBlock {
  public:
    /// Returns the block's size in bytes; 0 when there can be no such image (no pixels, a number of
    /// channels other than 1, 3 or 4, more than a gigabyte).
    static std::size_t sizeFor(int width, int height, int channels);

    /// Writes the image into a block of sizeFor(...) bytes. `bits` is that of the file's whole
    /// numbers where the image holds these, see FileImage.
    static void write(std::span<std::byte> block, const Image& image, int bits = 0);

    /// Returns an image another process wrote, checked: its sizes against the block's length.
    static Result<Image> checked(std::span<const std::byte> block);

    /// Returns the bits that were written into a checked block.
    static int bits(std::span<const std::byte> block);
};

} // namespace patina
