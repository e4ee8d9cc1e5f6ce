// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <glm/vec2.hpp>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Returns the linear image of a framebuffer, times two to the power of the exposure.
Image readLinear(unsigned framebuffer, glm::ivec2 size, double exposure);

/// Returns what `show` draws into a framebuffer of 8-bit channels, divided by 255.
Result<Image> readDisplay(glm::ivec2 size, const std::function<void(unsigned)>& show);

} // namespace patina
