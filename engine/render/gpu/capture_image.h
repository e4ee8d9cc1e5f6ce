// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <glm/vec2.hpp>

#include "core/error.h"
#include "core/image.h"

namespace patina {

/// Returns the linear image of a framebuffer, RGBA with rows from the top. Colors are multiplied by
/// two to the power of `exposure`, clamped to +-40; alpha is not.
Image readLinear(unsigned framebuffer, glm::ivec2 size, double exposure);

/// Returns what `show` draws into the framebuffer that it is given: 8-bit RGBA, divided by 255,
/// rows from the top. Fails when the driver cannot draw to it.
Result<Image> readDisplay(glm::ivec2 size, const std::function<void(unsigned)>& show);

} // namespace patina
