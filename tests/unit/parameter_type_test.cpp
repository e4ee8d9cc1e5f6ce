// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter_type.h"

#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "catalog/curve.h"
#include "catalog/ramp.h"
#include "catalog/value_json.h"
#include "core/color.h"

namespace patina::parameter_type_test {
namespace {

/// A parameter of the type from 0 to 1, with the default that its type would have.
Parameter parameterOf(ParameterType type) {
    Parameter parameter;
    parameter.id = "p";
    parameter.type = type;
    parameter.values = {{"one", "The one", "", false}, {"two", "The other", "", false}};
    static const std::map<ParameterType, Value> defaults{
        {ParameterType::Int, 1},
        {ParameterType::Bool, true},
        {ParameterType::Color, glm::dvec3(0.5)},
        {ParameterType::Vec2, glm::dvec2(0.5)},
        {ParameterType::Vec3, glm::dvec3(0.5)},
        {ParameterType::Enum, std::string("one")},
        {ParameterType::Texture, std::string()},
        {ParameterType::Measured, std::string()},
        {ParameterType::Curve, curveValue(curvePresets()[0].points)},
        {ParameterType::Ramp, rampValue({RampInterpolation::Smooth, {{0.0, glm::dvec3(0.5)}}})}};
    const auto found = defaults.find(type);
    parameter.defaultValue = found == defaults.end() ? Value(0.5) : found->second;
    return parameter;
}

class EveryType : public testing::TestWithParam<ParameterType> {
  protected:
    const ParameterTypeInfo& info_ = infoOf(GetParam());
    Parameter parameter_ = parameterOf(GetParam());
    std::vector<Value> edgeCases_ =
        info_.edgeCases(parameter_, std::vector<double>{0.0, 1.0, 0.25});
};

TEST_P(EveryType, Word_NamesIt) {
    EXPECT_EQ(parameterTypeOf(info_.word), GetParam());
}

TEST_P(EveryType, EdgeCaseValue_IsWhatItIsMadeOf) {
    for (const Value& value : edgeCases_) {
        EXPECT_EQ(roundedToFloat(conformed(parameter_, value)), roundedToFloat(value))
            << textOf(value);
    }
}

TEST_P(EveryType, Json_ReadsBack) {
    for (const Value& value : edgeCases_) {
        const ValueReading read = valueFromJson(parameter_, toJson(value));
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_EQ(*read, value) << toJson(value).dump();
    }
}

TEST_P(EveryType, Text_ReadsBack) {
    for (const Value& value : edgeCases_) {
        const std::optional<Value> read = info_.fromText(parameter_, textOf(roundedToFloat(value)));
        ASSERT_TRUE(read) << textOf(value);
        EXPECT_EQ(roundedToFloat(*read), roundedToFloat(value)) << textOf(value);
    }
}

TEST_P(EveryType, Numbers_AreFinite) {
    std::vector<double> numbers(maxComponents, std::nan(""));
    for (const Value& value : edgeCases_) {
        writeNumbers(parameter_, value, numbers.data());
        for (int i = 0; i < info_.components; ++i) {
            EXPECT_TRUE(std::isfinite(numbers[static_cast<std::size_t>(i)])) << textOf(value);
        }
    }
}

TEST_P(EveryType, WhatIsNoValueOfIt_IsWrittenAsTheDefault) {
    std::vector<double> usual(maxComponents, 7.0);
    std::vector<double> written(maxComponents, 7.0);
    writeNumbers(parameter_, parameter_.defaultValue, usual.data());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Value& wrong :
         {Value(nan), Value(glm::dvec2(nan)), Value(glm::dvec3(1.0, nan, 0.0)),
          Value(NumberList{"nothing", {1.0}}), Value(NumberList{infoOf(GetParam()).word, {nan}})}) {
        writeNumbers(parameter_, wrong, written.data());
        EXPECT_EQ(written, usual);
    }
}

TEST_P(EveryType, State_HasAWordAndAValue) {
    if (info_.states == nullptr) {
        return;
    }
    const std::vector<Value> states = info_.states(parameter_);
    for (std::size_t i = 0; i < states.size(); ++i) {
        EXPECT_EQ(info_.state(parameter_, states[i]), i);
        EXPECT_NE(info_.stateWord(parameter_, i), "");
    }
}

TEST_P(EveryType, WhatMayBeTyped_IsSaid) {
    EXPECT_NE(info_.expected(parameter_), "");
    EXPECT_NE(info_.range(parameter_), "");
    EXPECT_LE(info_.components, maxComponents);
}

INSTANTIATE_TEST_SUITE_P(All, EveryType,
                         testing::ValuesIn(parameterTypes().begin(), parameterTypes().end()),
                         [](const auto& type) { return std::string(infoOf(type.param).word); });

std::string errorOf(ParameterType type, const char* json) {
    const auto value = valueFromJson(parameterOf(type), nlohmann::json::parse(json));
    return value ? std::string("no error") : value.error().text();
}

TEST(CurveFromJson, OnePoint_IsRefused) {
    EXPECT_EQ(errorOf(ParameterType::Curve, R"({"points": [[0, 0]]})"),
              "1 points stand here; expected 2 to 16 points");
}

TEST(CurveFromJson, ManyPoints_AreRefused) {
    nlohmann::json points = nlohmann::json::array();
    for (int i = 0; i < 100000; ++i) {
        points.push_back({i / 1e5, 0.5});
    }
    const auto value = valueFromJson(parameterOf(ParameterType::Curve), {{"points", points}});
    EXPECT_EQ(value.error().text(), "100000 points stand here; expected 2 to 16 points");
}

TEST(CurveFromJson, PointsThatGoBack_AreNamed) {
    EXPECT_EQ(errorOf(ParameterType::Curve, R"({"points": [[0, 0], [0.5, 1], [0.25, 1]]})"),
              "point 3 of the curve has x = 0.25 after 0.5; expected an x that is 0.001 larger or "
              "more");
}

TEST(CurveFromJson, PointBeyondTheEnd_IsNamed) {
    EXPECT_EQ(errorOf(ParameterType::Curve, R"({"points": [[0, 0], [1.5, 1]]})"),
              "point 2 of the curve has x = 1.5; expected an x from 0 to 1");
}

TEST(CurveFromJson, WhatIsNoPoint_IsNamed) {
    for (const char* json : {R"({"points": [[0, 0], [1]]})", R"({"points": [[0, 0], "x"]})",
                             R"({"points": [[0, 0], [1, null]]})"}) {
        EXPECT_NE(errorOf(ParameterType::Curve, json)
                      .find("stands for point 2 of the curve; expected a point: an array of 2"),
                  std::string::npos)
            << json;
    }
}

TEST(CurveFromJson, WhatIsNoCurve_SaysWhatOneLooksLike) {
    for (const char* json : {"1", "[[0, 0], [1, 1]]", "{}", R"({"points": 3})",
                             R"({"points": [[0, 0], [1, 1]], "more": 1})"}) {
        EXPECT_NE(errorOf(ParameterType::Curve, json).find("\"points\": [["), std::string::npos)
            << json;
    }
}

/// Where in a value a mistake is, as a JSON pointer.
std::string placeOfMistake(ParameterType type, const char* json) {
    const auto value = valueFromJson(parameterOf(type), nlohmann::json::parse(json));
    return value ? std::string("no error") : value.error().within;
}

TEST(ValueFromJson, MistakeInAPointOrAStop_IsPlacedThere) {
    EXPECT_EQ(placeOfMistake(ParameterType::Curve, R"({"points": [[0, 0], [0.5, 1], [0.25, 1]]})"),
              "/points/2");
    EXPECT_EQ(placeOfMistake(ParameterType::Curve, R"({"points": [[0, 0], "x"]})"), "/points/1");
    EXPECT_EQ(placeOfMistake(ParameterType::Ramp,
                             R"({"stops": [{"at": 0, "color": [0, 0, 0]}, {"at": 1}]})"),
              "/stops/1");
    EXPECT_EQ(placeOfMistake(ParameterType::Ramp, R"({"stops": [], "a/b": 1})"), "/a~1b");
    EXPECT_EQ(placeOfMistake(ParameterType::Curve, "1"), "");
}

TEST(BroughtIn, FirstPartOutsideItsRange_IsNamedAndPlaced) {
    const Parameter curve = parameterOf(ParameterType::Curve);
    const Value given = curveValue(CurvePoints{{0.0, 0.0}, {0.5, 2.0}, {1.0, 3.0}});
    EXPECT_EQ(broughtIn(given, conformed(curve, given)).name, "point 2");
    EXPECT_EQ(broughtIn(given, conformed(curve, given)).pointer, "/points/1");
    const Value stops = rampValue({RampInterpolation::Linear, {{0.0, {}}, {1.0, {0.0, 0.0, 9.0}}}});
    EXPECT_EQ(broughtIn(stops, conformed(parameterOf(ParameterType::Ramp), stops)).name, "stop 2");
    EXPECT_EQ(broughtIn(2.0, 1.0).name, "");
}

TEST(CurveFromText, PresetAndPoints_AreRead) {
    const Parameter parameter = parameterOf(ParameterType::Curve);
    const ParameterTypeInfo& info = infoOf(ParameterType::Curve);
    EXPECT_EQ(info.fromText(parameter, "ease"), curveValue(curvePresets()[1].points));
    EXPECT_EQ(info.fromText(parameter, "0,0 0.5,0.7 1,1"),
              curveValue(CurvePoints{{0.0, 0.0}, {0.5, 0.7}, {1.0, 1.0}}));
    EXPECT_EQ(info.fromText(parameter, R"({"points": [[0, 1], [1, 0]]})"),
              curveValue(CurvePoints{{0.0, 1.0}, {1.0, 0.0}}));
    for (const char* wrong : {"", "0", "0,0,1", "easy", "{", "0,0 1,x"}) {
        EXPECT_FALSE(info.fromText(parameter, wrong)) << wrong;
    }
}

TEST(CurveConformed, PointsOutOfOrder_AreSortedAndKeptApart) {
    const Parameter parameter = parameterOf(ParameterType::Curve);
    EXPECT_EQ(conformed(parameter, curveValue(CurvePoints{{1.0, 2.0}, {0.2, -1.0}, {0.2003, 0.5}})),
              curveValue(CurvePoints{{0.2, 0.0}, {1.0, 1.0}}));
}

/// The curve never leaves the two values beside a place, and reaches every point.
TEST(CurveShape, BetweenPoints_StaysBetweenThem) {
    for (const Value& value :
         infoOf(ParameterType::Curve)
             .edgeCases(parameterOf(ParameterType::Curve), std::vector<double>{0.0, 0.3, 1.0})) {
        const CurvePoints points = curvePoints(value);
        const CurveShape shape(points);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            EXPECT_NEAR(shape.at(points[i].x), points[i].y, 1e-12);
            const auto [low, high] = std::minmax(points[i].y, points[i + 1].y);
            double last = points[i].y;
            for (double share = 0.0; share <= 1.0; share += 1.0 / 64.0) {
                const double y = shape.at(points[i].x + share * (points[i + 1].x - points[i].x));
                EXPECT_GE(y, low - 1e-12);
                EXPECT_LE(y, high + 1e-12);
                EXPECT_GE((y - last) * (points[i + 1].y - points[i].y), -1e-12);
                last = y;
            }
        }
    }
}

/// Half-way between two points a cubic is (y0 + y1) / 2 + h (m0 - m1) / 8. The slopes by hand: at
/// the end ((2 h0 + h1) d0 - h0 d1) / (h0 + h1), inside the harmonic mean of d = 2 and 0.4.
TEST(CurveShape, HalfWayBetweenTwoPoints_IsTheCubicOfTheirSlopes) {
    const CurveShape shape(CurvePoints{{0.0, 0.0}, {0.25, 0.5}, {0.5, 0.6}, {1.0, 1.0}});
    const double atEnd = (0.75 * 2.0 - 0.25 * 0.4) / 0.5;
    const double inside = 2.0 / (1.0 / 2.0 + 1.0 / 0.4);
    EXPECT_NEAR(shape.at(0.125), 0.25 + 0.25 * (atEnd - inside) / 8.0, 1e-12);
}

TEST(CurveShape, StraightPoints_AreTheLine) {
    const CurveShape shape(CurvePoints{{0.0, 0.0}, {0.3, 0.3}, {1.0, 1.0}});
    for (double x = 0.0; x <= 1.0; x += 0.01) {
        EXPECT_NEAR(shape.at(x), x, 1e-15);
    }
}

TEST(IsLinear, Diagonal_IsAndNothingElse) {
    EXPECT_TRUE(isLinear(CurvePoints{{0.0, 0.0}, {0.3, 0.3}, {1.0, 1.0}}));
    EXPECT_FALSE(isLinear(CurvePoints{{0.1, 0.1}, {1.0, 1.0}}));
    EXPECT_FALSE(isLinear(CurvePoints{{0.0, 0.0}, {0.3, 0.31}, {1.0, 1.0}}));
}

TEST(RampFromJson, Mistakes_AreNamed) {
    EXPECT_EQ(errorOf(ParameterType::Ramp, R"({"stops": []})"),
              "0 stops stand here; expected 1 to 16 stops");
    EXPECT_EQ(errorOf(ParameterType::Ramp,
                      R"({"stops": [{"at": 0.5, "color": [0, 0, 0]},
                                    {"at": 0.2, "color": [0, 0, 0]}]})"),
              "stop 2 of the ramp is at 0.2 after 0.5; expected a place that is 0.001 further or "
              "more");
    EXPECT_EQ(errorOf(ParameterType::Ramp, R"({"stops": [{"at": 2, "color": [0, 0, 0]}]})"),
              "stop 1 of the ramp is at 2; expected a place from 0 to 1");
    EXPECT_NE(errorOf(ParameterType::Ramp,
                      R"({"interpolation": "smoth", "stops": [{"at": 0, "color": [0, 0, 0]}]})")
                  .find("'smooth'"),
              std::string::npos);
    EXPECT_NE(errorOf(ParameterType::Ramp, R"({"stops": [{"at": 0}]})")
                  .find("an object stands for stop 1 of the ramp; expected a stop: {"),
              std::string::npos);
    EXPECT_NE(errorOf(ParameterType::Ramp, "[]").find("a ramp: {"), std::string::npos);
}

TEST(RampFromText, WordsAndColours_AreRead) {
    const Parameter parameter = parameterOf(ParameterType::Ramp);
    const auto read =
        infoOf(ParameterType::Ramp).fromText(parameter, "constant 0:#ff0000 0.5:0.1,0.2,0.3");
    ASSERT_TRUE(read);
    EXPECT_EQ(rampOf(*read), (Ramp{RampInterpolation::Constant,
                                   {{0.0, {1.0, 0.0, 0.0}}, {0.5, {0.1, 0.2, 0.3}}}}));
    for (const char* wrong : {"", "smooth", "0:", "0:red", "x:#ffffff", "smooth 0"}) {
        EXPECT_FALSE(infoOf(ParameterType::Ramp).fromText(parameter, wrong)) << wrong;
    }
}

TEST(Ramp, Interpolation_SaysHowItGoesOn) {
    Ramp ramp{RampInterpolation::Linear, {{0.2, glm::dvec3(0.0)}, {0.6, glm::dvec3(1.0)}}};
    EXPECT_EQ(ramp.at(0.0).x, 0.0);
    EXPECT_NEAR(ramp.at(0.3).x, 0.25, 1e-15);
    EXPECT_EQ(ramp.at(0.9).x, 1.0);
    ramp.interpolation = RampInterpolation::Smooth;
    EXPECT_NEAR(ramp.at(0.3).x, 0.15625, 1e-15);
    ramp.interpolation = RampInterpolation::Constant;
    EXPECT_EQ(ramp.at(0.59).x, 0.0);
    EXPECT_EQ(ramp.at(0.6).x, 1.0);
}

TEST(ColorOfHex, Text_IsReadBack) {
    EXPECT_EQ(hexOf(*colorOfHex("#8cf")), "#88ccff");
    EXPECT_EQ(hexOf(*colorOfHex(" 88ccff ")), "#88ccff");
    EXPECT_FALSE(colorOfHex(""));
    EXPECT_FALSE(colorOfHex("#12345g"));
}

} // namespace
} // namespace patina::parameter_type_test
