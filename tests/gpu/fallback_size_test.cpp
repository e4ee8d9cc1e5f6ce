// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gpu/fallback_size.h"

#include <bit>

#include <gtest/gtest.h>

namespace patina::fallback_size_test {
namespace {

bool isPowerOfTwo(int length) {
    return std::has_single_bit(static_cast<unsigned>(length));
}

TEST(FallbackSize, EachSide_IsAPowerOfTwoWhereTheRealOneIs) {
    for (const int width : {1, 2, 3, 640, 1023, 1024, 1366, 4096}) {
        for (const int height : {1, 480, 512, 1000}) {
            const glm::ivec2 size = fallbackSize({width, height}, {16, 9});
            EXPECT_EQ(isPowerOfTwo(size.x), isPowerOfTwo(width)) << width;
            EXPECT_EQ(isPowerOfTwo(size.y), isPowerOfTwo(height)) << height;
        }
    }
}

TEST(FallbackSize, OfAScaledPicture_HoldsForWhatIsDrawnToo) {
    const auto scaled = [](int length) { return (3 * length + 2) / 4; }; // rounded
    for (const int width : {640, 1024, 1365, 1000}) {
        const int side = fallbackSize({width, width}, {16, 16}, 0.75).x;
        EXPECT_EQ(isPowerOfTwo(side), isPowerOfTwo(width)) << width;
        EXPECT_EQ(isPowerOfTwo(scaled(side)), isPowerOfTwo(scaled(width))) << width;
    }
}

TEST(FallbackSize, IsNearTheSmallOne) {
    const glm::ivec2 size = fallbackSize({1600, 1024}, {16, 10});
    EXPECT_EQ(size, glm::ivec2(17, 16));
    EXPECT_EQ(fallbackSize({1600, 1}, {16, 0}), glm::ivec2(17, 1));
}

} // namespace
} // namespace patina::fallback_size_test
