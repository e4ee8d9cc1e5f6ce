// SPDX-License-Identifier: GPL-3.0-or-later
// The parameter type that CONTRIBUTING.md shows, as it stands there: its row and its name make it a
// type like all others. What all types promise is tried of it by the unit tests' file.
#include <gtest/gtest.h>

#include "catalog/parameter.h"

namespace patina::tests::added_type_test {
namespace {

Parameter brightness() {
    Parameter parameter;
    parameter.id = "brightness";
    parameter.type = ParameterType::Stops;
    parameter.defaultValue = 0.0;
    parameter.min = -4.0;
    parameter.max = 4.0;
    return parameter;
}

double inTheShader(const Value& value) {
    double number = 0.0;
    writeNumbers(brightness(), value, &number);
    return number;
}

TEST(TypeOfTheGuide, Word_NamesIt) {
    EXPECT_EQ(parameterTypeOf("stops"), ParameterType::Stops);
    EXPECT_EQ(parameterTypes().back(), ParameterType::Stops);
}

TEST(TypeOfTheGuide, EachStop_DoublesTheShadersNumber) {
    EXPECT_EQ(inTheShader(0.0), 1.0);
    EXPECT_EQ(inTheShader(3.0), 8.0);
    EXPECT_EQ(inTheShader(-1.0), 0.5);
}

TEST(TypeOfTheGuide, NumberOutOfRange_IsBroughtIntoItFirst) {
    EXPECT_EQ(inTheShader(100.0), 16.0);
}

} // namespace
} // namespace patina::tests::added_type_test
