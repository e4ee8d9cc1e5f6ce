// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture_histogram.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace patina::tests::picture_histogram_test {
namespace {

using H = PictureHistogram;

Image picture(std::initializer_list<std::array<float, 3>> colors) {
    Image image{static_cast<int>(colors.size()), 1, 4, {}};
    for (const auto& [red, green, blue] : colors) {
        image.pixels.insert(image.pixels.end(), {red, green, blue, 1.0f});
    }
    return image;
}

std::uint64_t sum(const H::Counts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
}

TEST(PictureHistogram, OfEveryLevel_HasOnePixelInEachBin) {
    Image image{256, 1, 1, {}};
    for (int level = 0; level < 256; ++level) {
        image.pixels.push_back(static_cast<float>(level) / 255.0f);
    }
    const H histogram = levelHistogram(image);
    for (const H::Counts& counts : histogram.counts) {
        EXPECT_EQ(counts, H::Counts(256, 1));
    }
    EXPECT_DOUBLE_EQ(histogram.clippedAny, 1.0 / 256.0);
    EXPECT_DOUBLE_EQ(histogram.black, 1.0 / 256.0);
}

TEST(PictureHistogram, OfAClippedChannel_SaysWhichAndHowMuch) {
    const H histogram = levelHistogram(
        picture({{1.0f, 0.5f, 0.0f}, {0.2f, 0.2f, 0.2f}, {0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}}));
    EXPECT_DOUBLE_EQ(histogram.clipped[H::Red], 0.5);
    EXPECT_DOUBLE_EQ(histogram.clipped[H::Green], 0.25);
    EXPECT_DOUBLE_EQ(histogram.clipped[H::Luminance], 0.25);
    EXPECT_DOUBLE_EQ(histogram.clippedAny, 0.5);
    EXPECT_DOUBLE_EQ(histogram.black, 0.25);
    EXPECT_DOUBLE_EQ(histogram.share(H::Red, 51), 0.25);
}

TEST(PictureHistogram, OfLight_CountsStopsAroundWhite) {
    const float middle = std::exp2(-2.45f);
    const H histogram = stopHistogram(picture(
        {{middle, middle, middle}, {middle, middle, middle}, {326.0f, 326.0f, 326.0f}, {0, 0, 0}}));
    EXPECT_DOUBLE_EQ(histogram.clippedAny, 0.25);
    const auto [median, max] = brightnessOf(histogram);
    EXPECT_NEAR(median, -2.45, 0.5 / binsPerStop);
    EXPECT_NEAR(max, std::log2(326.0), 1e-6); // beyond the range of the bins
    EXPECT_DOUBLE_EQ(histogram.share(H::Green, 0), 0.25);
}

TEST(PictureHistogram, OfWhatIsNoLight_StaysInItsBins) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const Image image = picture({{nan, -1.0f, infinity}});
    for (const H& histogram : {levelHistogram(image), stopHistogram(image)}) {
        EXPECT_EQ(sum(histogram.counts[H::Red]), 0u);
        EXPECT_EQ(histogram.counts[H::Green].front(), 1u);
        EXPECT_EQ(histogram.counts[H::Blue].back(), 1u);
    }
}

TEST(PictureHistogram, OfNothing_IsEmpty) {
    const H histogram = stopHistogram(Image());
    EXPECT_EQ(histogram.pixels, 0u);
    EXPECT_EQ(histogram.share(H::Luminance, 0), 0.0);
    EXPECT_EQ(brightnessOf(histogram).max, minStop);
}

} // namespace
} // namespace patina::tests::picture_histogram_test
