// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <glm/vec2.hpp>

#include "core/image.h"

namespace patina {

/// Writes a line of text onto a display image (3 or 4 channels): white capitals, digits and common
/// signs of 5 x 7 squares on a dark background. `corner` is the background's top left, `scale` the
/// size of one square in pixels. What does not fit between the corner and `right` is cut off.
void drawLabel(Image& image, std::string_view text, glm::ivec2 corner, int scale, int right);

/// Returns the width of a label's background in pixels, before it is cut off.
int labelWidth(std::string_view text, int scale);

/// Returns the height of a label's background in pixels.
int labelHeight(int scale);

} // namespace patina
