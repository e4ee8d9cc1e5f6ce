// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/image.h"
#include "core/texture_picture.h"

namespace patina {

/// Says how the numbers of an image file become light or data.
enum class TextureDecoding {
    Linear, ///< takes the numbers as they are
    Srgb,   ///< decodes them from sRGB
    Color,  ///< decodes integers from sRGB and takes floats as linear
};

/// Holds an image with the numbers of its file, not decoded; integers are divided by the largest
/// one.
struct FileImage {
    Image image;
    int bits = 0; ///< is the size of each integer in the file; 0 when it holds floats
};

/// Makes the texture of an image. Numbers that are not finite become 0, the others are clamped to
/// +-65504. Smaller mip levels are means of linear light, not of encoded values. Returns early with
/// fewer levels when `cancelled` returns true.
TexturePicture madeTexture(const FileImage& source, TextureDecoding decoding,
                           const std::function<bool()>& cancelled = {});

} // namespace patina
