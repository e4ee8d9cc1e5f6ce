// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace patina {

/// Returns true when a window would notice that images of this size, in pixels, are allocated.
/// Drivers that draw on the CPU fill their memory, which takes some 10 ms for a view with several
/// samples per pixel.
constexpr bool isSlowToAllocate(glm::ivec2 size) {
    return std::int64_t(size.x) * size.y >= std::int64_t(1) << 18;
}

} // namespace patina
