// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "assets/asset_client.h"
#include "support/program.h"

namespace patina::tests {
namespace {

/// A gradient in all channels, alpha included, so that no two neighbours are equal.
Image gradient(int width, int height, int channels) {
    Image image{width, height, channels, {}};
    const int count = width * height * channels;
    for (int i = 0; i < count; ++i) {
        image.pixels.push_back(static_cast<float>(i + 1) / static_cast<float>(count));
    }
    return image;
}

float largestDifference(const Image& a, const Image& b) {
    float largest = a.pixels.size() == b.pixels.size() ? 0.0f : 1e30f;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
        largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
    }
    return largest;
}

Result<Image> roundTrip(const std::string& name, const Image& image) {
    const TemporaryFolder folder;
    AssetClient client;
    return client.saveImage(folder / name, image).and_then([&] {
        return client.loadImage(folder / name);
    });
}

/// Half a step of an 8-bit code where the sRGB curve is steepest: 0.5 / 255 * 2.2.
constexpr float eightBitTolerance = 0.0045f;

TEST(ImageFile, PngWithAlpha_ReadsBackWithinHalfAStep) {
    const Image image = gradient(16, 9, 4);
    const auto read = roundTrip("a.png", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), eightBitTolerance);
}

TEST(ImageFile, GreyPng_ReadsBackWithinHalfAStep) {
    const Image image = gradient(16, 9, 1);
    const auto read = roundTrip("a.png", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->channels, 1);
    EXPECT_LE(largestDifference(*read, image), eightBitTolerance);
}

TEST(ImageFile, ExrWithAlpha_ReadsBackToTheLastBits) {
    const Image image = gradient(16, 9, 4);
    const auto read = roundTrip("a.exr", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), 2e-7f); // multiplied by alpha, then divided
}

TEST(ImageFile, ExrWithoutAlpha_ReadsBackTheSameFloats) {
    Image image = gradient(16, 9, 3);
    image.pixels[0] = 1e6f;
    image.pixels[1] = 1e-6f;
    const auto read = roundTrip("a.exr", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, image);
}

TEST(ImageFile, Hdr_ReadsBackWithinItsSharedExponent) {
    const Image image = gradient(16, 9, 3);
    const auto read = roundTrip("a.hdr", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), 1.0f / 128.0f); // 8 bits of mantissa below 1
}

TEST(ImageFile, JpegOfOneColor_ReadsBackThatColor) {
    Image image{16, 16, 3, {}};
    image.pixels.assign(16 * 16 * 3, 0.5f);
    const auto read = roundTrip("a.jpg", image);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_LE(largestDifference(*read, image), 2.0f * eightBitTolerance); // chroma rounding too
}

} // namespace
} // namespace patina::tests
