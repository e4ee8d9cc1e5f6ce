// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Returns the bytes of a PNG file, 8-bit sRGB. It uses libpng itself: pictures are written as PNG
/// most of the time, and loading OpenImageIO would take longer than all of the writing.
Result<std::string> encodedPng(const Image& image);

} // namespace patina
