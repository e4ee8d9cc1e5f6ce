// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/picture_distance.h"

#include <gtest/gtest.h>

#include "measure/error/structural_similarity.h"

namespace patina::picture_distance_test {
namespace {

constexpr int side = 24;
constexpr std::size_t pixels = side * side;

std::vector<double> flat(double value) {
    return std::vector<double>(pixels, value);
}

std::vector<double> stripes(double middle, double height) {
    std::vector<double> plane;
    for (std::size_t i = 0; i < pixels; ++i) {
        plane.push_back(middle + (i % 4 < 2 ? height : -height));
    }
    return plane;
}

double similarity(const std::vector<double>& a, const std::vector<double>& b) {
    return structuralSimilarity({side, side}, a, b);
}

Image grey(float value) {
    return {side, side, 4, std::vector<float>(4 * pixels, value)};
}

bool never() {
    return false;
}

TEST(StructuralSimilarity, SamePictures_IsOne) {
    EXPECT_NEAR(similarity(stripes(0.5, 0.3), stripes(0.5, 0.3)), 1.0, 1e-12);
}

/// Equations 6 and 13 of the paper, where nothing varies.
TEST(StructuralSimilarity, FlatPictures_IsTheLuminanceTerm) {
    const double expected = (2.0 * 0.2 * 0.6 + 1e-4) / (0.2 * 0.2 + 0.6 * 0.6 + 1e-4);
    EXPECT_NEAR(similarity(flat(0.2), flat(0.6)), expected, 1e-12);
}

TEST(StructuralSimilarity, InvertedStripes_IsBelowZero) {
    EXPECT_LT(similarity(stripes(0.5, 0.3), stripes(0.5, -0.3)), -0.9);
}

TEST(PictureDistance, SamePictures_AreNotApart) {
    const auto distance =
        pictureDistance(std::vector<float>(pixels, 0.0f), grey(0.5f), grey(0.5f), never);
    ASSERT_TRUE(distance);
    EXPECT_EQ(distance->flip, 0.0);
    EXPECT_NEAR(distance->similarity, 1.0, 1e-12);
    EXPECT_EQ(distance->largest, 0.0);
}

TEST(PictureDistance, FewWrongPixels_AreInTheLargestAndTheMeanOnly) {
    std::vector<float> relative(pixels, 0.25f);
    relative[7] = 2.0f;
    const auto distance = pictureDistance(relative, grey(0.5f), grey(0.6f), never);
    ASSERT_TRUE(distance);
    EXPECT_EQ(distance->largest, 2.0);
    EXPECT_EQ(distance->percentile99, 0.25);
    EXPECT_NEAR(distance->mean, 0.25 + 1.75 / double(pixels), 1e-6);
    EXPECT_GT(distance->flip, 0.0);
}

} // namespace
} // namespace patina::picture_distance_test
