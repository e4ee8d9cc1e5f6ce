// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/png_writer.h"

#include <png.h>

#include "core/srgb_table.h"

namespace patina {
namespace {

png_uint_32 formatFor(int channels) {
    return channels == 1 ? PNG_FORMAT_GRAY : channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
}

} // namespace

Result<std::string> encodedPng(const Image& image) {
    const auto codes = SrgbTable().codes(image, image.channels);
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = formatFor(image.channels);
    png.flags = PNG_IMAGE_FLAG_FAST; // a quarter of the time for a fifth more bytes
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, codes.data(), 0, nullptr) == 0) {
        return failure(std::string("cannot encode as PNG: ") + png.message);
    }
    bytes.resize(size);
    return bytes;
}

} // namespace patina
