// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Reads and encodes pictures. It is an interface because its implementation needs OpenImageIO,
/// which brings 260 libraries along; that lives in a module, which is loaded for the first picture.
class ImageCodec {
  public:
    virtual ~ImageCodec() = default;

    /// Reads an image as linear light. Integer formats are decoded from sRGB, alpha is not
    /// premultiplied. Two channels are read as grey and alpha; of four or more the first four are
    /// read when the fourth is alpha, else the first three. Errors name the file.
    virtual Result<Image> read(const std::filesystem::path& file) const = 0;

    /// Reads the numbers as the file has them, integers divided by their largest value. `bits`
    /// becomes the number of bits of an integer, or 0 where the file holds floats.
    virtual Result<Image> readNumbers(const std::filesystem::path& file, int& bits) const = 0;

    /// Returns the bytes of an image file. `extension` is ".png", ".jpg", ".jpeg" (8-bit sRGB),
    /// ".exr" or ".hdr" (linear floats); any other is an error. What a format cannot hold is left
    /// out: alpha in .jpg and .hdr.
    virtual Result<std::string> encode(const std::string& extension, const Image& image) const = 0;
};

/// Names the function `const ImageCodec* ()` that the module exports.
inline constexpr const char* imageCodecSymbol = "patinaImageCodec";

} // namespace patina
