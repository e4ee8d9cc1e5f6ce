// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

namespace patina {

/// Returns a size near `small`, and not below it, that replaces `size` where nothing is to be seen:
/// a software driver compiles programs anew for images whose sides are powers of two, or are not.
/// The same holds for what is `scale` times as large (see PictureAccuracy::scale()). Sides are at
/// least 1 and grow by at most 64.
glm::ivec2 fallbackSize(glm::ivec2 size, glm::ivec2 small, double scale = 1.0);

} // namespace patina
