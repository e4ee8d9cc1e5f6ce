// SPDX-License-Identifier: GPL-3.0-or-later
// Two pictures taken from each other, and colours for errors.
#include "measure/error/frame_difference.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "measure/error/error_colors.h"

namespace patina::frame_difference_test {
namespace {

Image pixel(float red, float green, float blue) {
    return {1, 1, 4, {red, green, blue, 1.0f}};
}

TEST(FrameDifference, Channels_AreTakenByThemselves) {
    const FrameDifference difference =
        differenceOf(pixel(0.5f, 0.25f, 1.0f), pixel(0.25f, 0.5f, 1.0f));
    EXPECT_EQ(difference.apart[0], glm::vec3(0.25f, 0.25f, 0.0f));
    EXPECT_FLOAT_EQ(difference.relative[0], 0.25f);
}

TEST(FrameDifference, ShownWithGain_IsTheSrgbCode) {
    const FrameDifference difference =
        differenceOf(pixel(0.0f, 0.0f, 0.0f), pixel(0.0214f, 0.001f, 2.0f));
    const std::vector<unsigned char> shown = shownDifference(difference, 10.0);
    EXPECT_EQ(shown[0], 127); // 0.214 of the light is half of the codes
    EXPECT_EQ(shown[1], 25);
    EXPECT_EQ(shown[2], 255);
}

TEST(FrameDifference, WhatIsNoNumber_IsAsBrightAsCanBe) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const FrameDifference difference =
        differenceOf(pixel(1.0f, 1.0f, 1.0f), pixel(nan, 1.0f, 1.0f));
    EXPECT_EQ(shownDifference(difference, 1.0)[0], 255);
    EXPECT_EQ(shownErrors(difference)[0], 255);
}

TEST(ErrorColors, GreaterErrors_AreLighter) {
    double before = -1.0;
    for (double error = minErrorShown; error <= greatestErrorShown; error *= 2.0) {
        const glm::vec3 color = errorColor(error);
        const double light = 0.2126 * std::pow(color.x, 2.2) + 0.7152 * std::pow(color.y, 2.2) +
                             0.0722 * std::pow(color.z, 2.2);
        EXPECT_GT(light, before) << error;
        before = light;
    }
}

TEST(ErrorColors, NoError_IsBlack) {
    EXPECT_EQ(errorColor(0.0), glm::vec3(0.0f));
    EXPECT_EQ(errorPicture(std::vector<double>{0.0}, {1, 1}).pixels, std::vector<float>(3));
}

} // namespace
} // namespace patina::frame_difference_test
