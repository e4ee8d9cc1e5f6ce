// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter.h"

#include <cmath>
#include <limits>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "catalog/parameter_layout.h"
#include "catalog/value_json.h"

namespace patina::parameter_test {
namespace {

Parameter parameter(std::string id, ParameterType type, Value defaultValue) {
    Parameter made;
    made.id = std::move(id);
    made.type = type;
    made.defaultValue = std::move(defaultValue);
    made.values = {{"one", "", "", false}, {"two", "", "", false}};
    return made;
}

const Parameter number = parameter("n", ParameterType::Float, 0.5);
const Parameter whole = parameter("i", ParameterType::Int, 1);
const Parameter colour = parameter("c", ParameterType::Color, glm::dvec3(0.25));
const Parameter choice = parameter("e", ParameterType::Enum, std::string("one"));

TEST(Conformed, NumberInRange_StaysAsItIs) {
    EXPECT_EQ(conformed(number, 0.25), Value(0.25));
}
TEST(Conformed, NumberAboveTheRange_IsTheLargest) {
    EXPECT_EQ(conformed(number, 7.0), Value(1.0));
}
TEST(Conformed, FloatOfAnEnd_StaysAsItIs) {
    Parameter index = number;
    index.min = 0.01;
    const double read = static_cast<double>(0.01F);
    ASSERT_LT(read, index.min);
    EXPECT_EQ(conformed(index, read), Value(read));
    EXPECT_EQ(conformed(index, 0.0099), Value(0.01));
}
TEST(Conformed, TinyNumberBelowZero_IsZero) {
    EXPECT_EQ(conformed(number, -1e-60), Value(0.0));
}
TEST(Conformed, NotANumber_IsTheDefault) {
    EXPECT_EQ(conformed(number, std::numeric_limits<double>::quiet_NaN()), Value(0.5));
}
TEST(Conformed, Infinity_IsTheDefault) {
    EXPECT_EQ(conformed(number, HUGE_VAL), Value(0.5));
}
TEST(Conformed, ColourComponent_IsBroughtIntoRange) {
    EXPECT_EQ(conformed(colour, glm::dvec3(-1.0, 0.5, 2.0)), Value(glm::dvec3(0.0, 0.5, 1.0)));
}
TEST(Conformed, WrongType_IsTheDefault) {
    EXPECT_EQ(conformed(number, true), Value(0.5));
}
TEST(Conformed, UnknownChoice_IsTheDefault) {
    EXPECT_EQ(conformed(choice, std::string("three")), Value(std::string("one")));
}
TEST(Conformed, WholeNumberBeyondTheRange_IsTheLargest) {
    EXPECT_EQ(conformed(whole, 9), Value(1));
}

TEST(FieldName, DotsAndHyphens_BecomeCapitals) {
    EXPECT_EQ(fieldName("diffuse.color"), "diffuseColor");
    EXPECT_EQ(fieldName("roughness"), "roughness");
    EXPECT_EQ(fieldName("half-width.xAxis"), "halfWidthXAxis");
}

TEST(ValueFromJson, NumberForAColour_IsAnError) {
    EXPECT_EQ(valueFromJson(colour, -1).error().text(),
              "the number -1 stands here; expected a colour: an array of 3 numbers, linear red, "
              "green and blue");
}
TEST(ValueFromJson, TextInAColour_IsNamedWithItsPlace) {
    EXPECT_EQ(valueFromJson(colour, {1, 1, "x"}).error().problem,
              "an array of 3 with the text \"x\" at place 3 stands here");
}
TEST(ValueFromJson, ArrayThatIsTooShort_IsNamedByItsLength) {
    EXPECT_EQ(valueFromJson(colour, {1, 1}).error().problem, "an array of 2 stands here");
}
TEST(ValueFromJson, FractionForAWholeNumber_IsAnError) {
    EXPECT_FALSE(valueFromJson(whole, 1.5));
}
TEST(ValueFromJson, WholeFloatForAWholeNumber_IsRead) {
    EXPECT_EQ(valueFromJson(whole, 3.0), Value(3));
}
TEST(ValueFromJson, HugeWholeNumber_IsCut) {
    EXPECT_EQ(valueFromJson(whole, 1e300), Value(std::numeric_limits<int>::max()));
}
TEST(ValueFromJson, Number_IsNeitherRoundedNorCut) {
    EXPECT_EQ(valueFromJson(number, 7.1), Value(7.1));
}

class Layout : public testing::Test {
  protected:
    Layout() {
        block_.parameters = {number,
                             colour,
                             parameter("v", ParameterType::Vec2, glm::dvec2(1, 2)),
                             parameter("a", ParameterType::Angle, 90.0),
                             parameter("t", ParameterType::Texture, std::string()),
                             choice,
                             parameter("b", ParameterType::Bool, true)};
        block_.parameters[3].max = 360.0;
        block_.accuracy = {{"level", "", "", {{"exact", "", "", true}, {"fast", "", "", false}}}};
    }

    double at(const std::string& name, const Values& values, const AccuracyLevels& levels = {}) {
        for (const ParameterField& field : layoutOf(block_).fields) {
            if (field.name == name) {
                return packed(block_, values, levels)[field.offset];
            }
        }
        return NAN;
    }

    static glm::dvec3 direction(Space space, const glm::dvec3& value) {
        Block block;
        block.parameters = {parameter("d", ParameterType::Vec3, glm::dvec3(1.0))};
        block.parameters[0].space = space;
        block.parameters[0].min = -1e7;
        block.parameters[0].max = 1e7;
        const std::vector<double> out = packed(block, {{"d", value}}, {});
        return {out[0], out[1], out[2]};
    }

    Block block_;
};

TEST_F(Layout, Field_NeverStraddlesTwoVec4s) {
    for (const ParameterField& field : layoutOf(block_).fields) {
        EXPECT_LE(field.offset % 4 + static_cast<std::size_t>(field.components), 4u) << field.name;
    }
}
TEST_F(Layout, Fields_DoNotOverlap) {
    std::size_t end = 0;
    for (const ParameterField& field : layoutOf(block_).fields) {
        EXPECT_GE(field.offset, end) << field.name;
        end = field.offset + static_cast<std::size_t>(field.components);
    }
}
TEST_F(Layout, Size_IsAMultipleOfFour) {
    EXPECT_EQ(layoutOf(block_).floats % 4, 0u);
}
TEST_F(Layout, Texture_HasNoField) {
    EXPECT_EQ(layoutOf(block_).fields.size(), 7u);
}
TEST_F(Layout, EmptyBlock_HasNoFloats) {
    EXPECT_EQ(layoutOf(Block{}).floats, 0u);
}
TEST_F(Layout, Angle_IsPackedInRadians) {
    EXPECT_EQ(at("a", {{"a", 180.0}}), glm::radians(180.0));
}
TEST_F(Layout, Choice_IsPackedAsItsIndex) {
    EXPECT_EQ(at("e", {{"e", std::string("two")}}), 1.0);
}
TEST_F(Layout, Level_IsPackedAsItsIndex) {
    EXPECT_EQ(at("level", {}, {{"level", "fast"}}), 1.0);
}
TEST_F(Layout, MissingLevel_IsExact) {
    EXPECT_EQ(at("level", {}), 0.0);
}
TEST_F(Layout, MissingValue_IsTheDefault) {
    EXPECT_EQ(at("n", {}), 0.5);
}
TEST_F(Layout, WrongType_IsTheDefault) {
    EXPECT_EQ(at("n", {{"n", true}}), 0.5);
}
TEST_F(Layout, Bool_IsPackedAsOne) {
    EXPECT_EQ(at("b", {}), 1.0);
}
TEST_F(Layout, Direction_IsPackedUnit) {
    EXPECT_EQ(direction(Space::WorldDirection, {0, 0, -4}), glm::dvec3(0, 0, -1));
    EXPECT_EQ(direction(Space::CameraDirection, {3e6, 0, 4e6}), glm::dvec3(0.6, 0, 0.8));
}
TEST_F(Layout, DirectionWithoutLength_IsPackedAsStraightDown) {
    EXPECT_EQ(direction(Space::WorldDirection, {0, 0, 0}), glm::dvec3(0, -1, 0));
}
TEST_F(Layout, Point_IsPackedAsItIs) {
    EXPECT_EQ(direction(Space::WorldPoint, {0, 0, -4}), glm::dvec3(0, 0, -4));
}

} // namespace
} // namespace patina::parameter_test
