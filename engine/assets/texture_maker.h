// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/image.h"
#include "core/texture_picture.h"

namespace patina {

/// Tells how the numbers of an image file become light or data.
enum class TextureDecoding {
    Linear, ///< the numbers themselves
    Srgb,   ///< encoded in sRGB
    Color,  ///< encoded where the file holds whole numbers, linear where it holds floats
};

/// Represents an image with the numbers that its file holds: whole ones are divided by the largest.
struct FileImage {
    Image image;
    int bits = 0; ///< of each whole number; 0: the file holds floats
};

/// Returns the texture of an image. What is not finite is 0, and nothing is beyond +-65504. Smaller
/// versions are means of light, not of codes. Stops early, with fewer of them, when `cancelled`.
TexturePicture madeTexture(const FileImage& source, TextureDecoding decoding,
                           const std::function<bool()>& cancelled = {});

} // namespace patina
