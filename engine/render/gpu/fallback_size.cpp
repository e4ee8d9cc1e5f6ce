// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/fallback_size.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace patina {
namespace {

constexpr int maxAddedPixels = 64;

bool isPowerOfTwo(int length) {
    return std::has_single_bit(static_cast<unsigned>(length));
}

int scaledLength(int length, double scale) {
    return std::clamp(static_cast<int>(std::round(scale * length)), 1, length);
}

bool isAlike(int a, int b, double scale) {
    return isPowerOfTwo(a) == isPowerOfTwo(b) &&
           isPowerOfTwo(scaledLength(a, scale)) == isPowerOfTwo(scaledLength(b, scale));
}

int fallbackLength(int length, int small, double scale) {
    const int minSide = std::max(small, 1);
    for (int wanted = minSide; wanted <= minSide + maxAddedPixels; ++wanted) {
        if (isAlike(wanted, length, scale)) {
            return wanted;
        }
    }
    return minSide;
}

} // namespace

glm::ivec2 fallbackSize(glm::ivec2 size, glm::ivec2 small, double scale) {
    return {fallbackLength(size.x, small.x, scale), fallbackLength(size.y, small.y, scale)};
}

} // namespace patina
