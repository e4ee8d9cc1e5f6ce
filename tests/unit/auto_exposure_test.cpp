// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/auto_exposure.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace patina::tests::auto_exposure_test {
namespace {

Image grey(std::initializer_list<float> lights) {
    Image image{static_cast<int>(lights.size()), 1, 4, {}};
    for (const float light : lights) {
        image.pixels.insert(image.pixels.end(), {light, light, light, 1.0f});
    }
    return image;
}

TEST(AutoExposure, OfAnEvenPicture_MakesItMiddleGrey) {
    for (const float light : {1e-4f, 0.09f, 0.18f, 1.0f, 5000.0f}) {
        const auto stops = autoExposure(grey({light, light}));
        ASSERT_TRUE(stops);
        EXPECT_NEAR(light * std::exp2(*stops), 0.18, 0.18 * 0.004);
    }
}

TEST(AutoExposure, OfTwoBrightnesses_TakesTheMeanOfTheirLogarithms) {
    EXPECT_NEAR(*autoExposure(grey({0.18f * 16.0f, 0.18f})), -2.0, 1e-9);
}

TEST(AutoExposure, OfColours_TakesTheirLuminance) {
    const Image green{1, 1, 3, {0.0f, 0.18f / 0.7152f, 0.0f}};
    EXPECT_NEAR(*autoExposure(green), 0.0, 1e-9);
}

TEST(AutoExposure, BlackAndBrokenPixels_DoNotCount) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_NEAR(*autoExposure(grey({0.0f, nan, infinity, -1.0f, 0.36f})), -1.0, 1e-9);
}

TEST(AutoExposure, OfNothingThatIsSeen_IsNothing) {
    EXPECT_FALSE(autoExposure(grey({0.0f, 0.0f})));
    EXPECT_FALSE(autoExposure(Image()));
}

TEST(AutoExposure, OfTheBrightestLight_StaysInTheSlidersRange) {
    EXPECT_EQ(*autoExposure(grey({std::numeric_limits<float>::max()})), -32.0);
}

} // namespace
} // namespace patina::tests::auto_exposure_test
