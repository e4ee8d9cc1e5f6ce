// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_embedded.h"

#include <string_view>

#include "core/base64.h"

namespace patina {
namespace {

constexpr std::size_t maxEmbeddedBytes = std::size_t(32) << 20;

std::string_view bytesOf(const tinygltf::Image& image) {
    return {reinterpret_cast<const char*>(image.image.data()), image.image.size()};
}

/// Returns the type by the bytes themselves, whatever the file says of them; empty for another.
std::string_view typeOf(std::string_view bytes) {
    return bytes.starts_with("\x89PNG\r\n\x1a\n") ? "image/png"
           : bytes.starts_with("\xff\xd8\xff")    ? "image/jpeg"
                                                  : "";
}

} // namespace

bool isEmbeddedImage(const tinygltf::Image& image) {
    return image.uri.empty() && image.image.size() <= maxEmbeddedBytes &&
           !typeOf(bytesOf(image)).empty();
}

std::string embeddedImage(const tinygltf::Image& image) {
    return "data:" + std::string(typeOf(bytesOf(image))) + ";base64," + base64(bytesOf(image));
}

} // namespace patina
