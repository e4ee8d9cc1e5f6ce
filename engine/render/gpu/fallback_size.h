// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>

namespace patina {

/// Returns a size of at least `small` for a frame that nobody sees and that stands for one of
/// `size`. A software driver compiles programs once for sides that are powers of two and once for
/// others, so both sizes must be alike in that, also after a scaling by `scale` (see
/// PictureAccuracy::scale()). Sides are at least 1; they exceed `small` by at most 64.
glm::ivec2 fallbackSize(glm::ivec2 size, glm::ivec2 small, double scale = 1.0);

} // namespace patina
