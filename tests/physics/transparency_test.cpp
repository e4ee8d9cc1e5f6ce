// SPDX-License-Identifier: GPL-3.0-or-later
// What a weighted mean of surfaces makes of stacks whose true order is known.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "physics_cases.h"

namespace patina::physics::transparency_test {
namespace {

struct Sheet {
    double depth = 0.0;
    double opacity = 0.0;
    double grey = 0.0;
};

double weightOf(const Sheet& sheet, const Values& values = {}) {
    const Subject weighted("transparency", "weighted", values);
    return weighted.code->transparency(sheet.depth, sheet.opacity, weighted.parameters);
}

/// From the nearest to the farthest, over the background.
double inOrder(const std::vector<Sheet>& sheets, double background) {
    double light = 0.0;
    double left = 1.0;
    for (const Sheet& sheet : sheets) {
        light += left * sheet.opacity * sheet.grey;
        left *= 1.0 - sheet.opacity;
    }
    return light + left * background;
}

double mixed(const std::vector<Sheet>& sheets, double background) {
    double sum = 0.0;
    double weights = 0.0;
    double left = 1.0;
    for (const Sheet& sheet : sheets) {
        const double share = sheet.opacity * weightOf(sheet);
        sum += share * sheet.grey;
        weights += share;
        left *= 1.0 - sheet.opacity;
    }
    return (1.0 - left) * sum / weights + left * background;
}

/// Errors over random stacks of two to six sheets, smallest first.
std::vector<double> errorsOf(double maxOpacity) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::uniform_real_distribution<double> opacity(0.1, maxOpacity);
    std::uniform_int_distribution<int> count(2, 6);
    std::vector<double> errors;
    for (int i = 0; i < 4000; ++i) {
        std::vector<Sheet> sheets(static_cast<std::size_t>(count(random)));
        for (Sheet& sheet : sheets) {
            sheet = {share(random), opacity(random), share(random)};
        }
        std::ranges::sort(sheets, {}, &Sheet::depth);
        const double background = share(random);
        errors.push_back(std::abs(mixed(sheets, background) - inOrder(sheets, background)));
    }
    std::ranges::sort(errors);
    return errors;
}

double rootMeanSquare(const std::vector<double>& errors) {
    double squares = 0.0;
    for (const double error : errors) {
        squares += error * error;
    }
    return std::sqrt(squares / double(errors.size()));
}

// The figures that the descriptor states.

TEST(WeightedTransparency, ErrorOfThinSheets_IsAsStated) {
    const std::vector<double> errors = errorsOf(0.5);
    EXPECT_NEAR(rootMeanSquare(errors), 0.04, 0.005);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.09);
}

TEST(WeightedTransparency, ErrorOfDenserSheets_IsAsStated) {
    const std::vector<double> errors = errorsOf(0.9);
    EXPECT_NEAR(rootMeanSquare(errors), 0.08, 0.01);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.17);
}

TEST(WeightedTransparency, NearSheets_CountMore) {
    EXPECT_GT(weightOf({0.1, 0.5, 0.0}), weightOf({0.2, 0.5, 0.0}));
    EXPECT_GT(weightOf({0.2, 0.5, 0.0}), weightOf({0.2, 0.4, 0.0}));
}

TEST(WeightedTransparency, AtTheFarthest_StillCounts) {
    EXPECT_GT(weightOf({1.0, 0.5, 0.0}, {{"falloff", 16.0}}), 1e-7);
}

TEST(WeightedTransparency, WithoutFalloff_CountsByOpacityAlone) {
    EXPECT_EQ(weightOf({0.9, 0.25, 0.0}, {{"falloff", 0.0}}), 0.25);
}

} // namespace
} // namespace patina::physics::transparency_test
