// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <tiny_gltf.h>

namespace patina {

/// Tells whether an image lies inside its file, as PNG or JPEG.
bool isEmbeddedImage(const tinygltf::Image& image);

/// Returns such an image as a data URI in base64.
std::string embeddedImage(const tinygltf::Image& image);

} // namespace patina
