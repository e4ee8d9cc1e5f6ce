// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/random_value.h"

#include <gtest/gtest.h>

namespace patina::random_value_test {
namespace {

Parameter number(double softMin, double softMax, Scale scale = Scale::Linear) {
    Parameter made;
    made.id = "n";
    made.max = 1e6;
    made.softMin = softMin;
    made.softMax = softMax;
    made.scale = scale;
    return made;
}

/// The value at a share of the slider.
double at(const Parameter& parameter, double share) {
    return std::get<double>(*randomValue(parameter, [share] { return share; }));
}

TEST(RandomValue, Number_LiesAlongItsSlider) {
    const Parameter parameter = number(2.0, 6.0);
    EXPECT_DOUBLE_EQ(at(parameter, 0.0), 2.0);
    EXPECT_DOUBLE_EQ(at(parameter, 0.25), 3.0);
    EXPECT_DOUBLE_EQ(at(parameter, 1.0), 6.0);
}

TEST(RandomValue, LogarithmicNumber_IsTheGeometricMeanInTheMiddle) {
    EXPECT_NEAR(at(number(1.0, 10000.0, Scale::Log), 0.5), 100.0, 1e-4);
}

TEST(RandomValue, Color_HasANumberForEachChannel) {
    Parameter parameter = number(0.0, 1.0);
    parameter.type = ParameterType::Color;
    parameter.defaultValue = glm::dvec3(0.0);
    double next = 0.0;
    const auto value = randomValue(parameter, [&] { return next += 0.25; });
    EXPECT_EQ(value, Value(glm::dvec3(0.25, 0.5, 0.75)));
}

TEST(RandomValue, ChoicesAndWhatGlows_HaveNone) {
    const auto half = [] { return 0.5; };
    Parameter choice = number(0.0, 1.0);
    choice.type = ParameterType::Enum;
    choice.defaultValue = std::string("one");
    choice.values = {{"one", "", "", false}, {"two", "", "", false}};
    EXPECT_FALSE(randomValue(choice, half));
    Parameter glow = number(0.0, 1.0);
    glow.type = ParameterType::Color;
    glow.defaultValue = glm::dvec3(0.0);
    glow.emission = true;
    EXPECT_FALSE(randomValue(glow, half));
}

} // namespace
} // namespace patina::random_value_test
