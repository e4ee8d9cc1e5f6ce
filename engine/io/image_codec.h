// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Reads and encodes pictures. An interface, because its implementation needs OpenImageIO, which
/// brings 260 libraries along; it lives in a module that is loaded when the first picture comes.
class ImageCodec {
  public:
    virtual ~ImageCodec() = default;

    /// Integer formats are decoded from sRGB to linear, alpha is not premultiplied. Two channels
    /// are read as grey and alpha, more than four as the first four. Errors name the file.
    virtual Result<Image> read(const std::filesystem::path& file) const = 0;

    /// The numbers as the file has them, whole ones divided by the largest; `bits` is that of each
    /// whole number, or 0 where the file holds floats.
    virtual Result<Image> readNumbers(const std::filesystem::path& file, int& bits) const = 0;

    /// The bytes of an image file. `extension` is ".png", ".jpg", ".jpeg" (8-bit sRGB), ".exr" or
    /// ".hdr" (linear floats). What a format cannot hold is left out: alpha in .jpg and .hdr.
    virtual Result<std::string> encode(const std::string& extension, const Image& image) const = 0;
};

/// The name under which the module exports `const ImageCodec* ()`.
inline constexpr const char* imageCodecSymbol = "patinaImageCodec";

} // namespace patina
