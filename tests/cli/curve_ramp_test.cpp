// SPDX-License-Identifier: GPL-3.0-or-later
// Curves and ramps on the command line and in preset files.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::curve_ramp_test {
namespace {

const std::string sketch = shipped("presets/gooch/sketch.patina.json").string();
const std::string cartoon = shipped("presets/toon/cartoon.patina.json").string();

Outcome picture(const std::string& preset, const std::vector<std::string>& assignments) {
    std::vector<std::string> arguments{"render", preset, "--size", "32x32", "-o", "-"};
    for (const std::string& assignment : assignments) {
        arguments.insert(arguments.end(), {"--set", assignment});
    }
    return patina(arguments);
}

TEST(SetCurve, AnyForm_IsTaken) {
    const std::string usual = picture(sketch, {}).out;
    for (const char* text : {"tone.curve=steps", "tone.curve=0,1 1,0",
                             R"(tone.curve={"points": [[0, 0.5], [1, 1]]})"}) {
        const Outcome outcome = picture(sketch, {text});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(outcome.out, usual) << text;
    }
}

TEST(SetCurve, StraightLine_IsThePictureWithoutOne) {
    const std::string usual = picture(sketch, {}).out;
    EXPECT_EQ(picture(sketch, {"tone.curve=linear"}).out, usual);
    EXPECT_EQ(picture(sketch, {"tone.curve=0,0 0.25,0.25 1,1"}).out, usual);
}

TEST(SetCurve, WhatIsNone_SaysWhatWouldBe) {
    for (const char* text : {"tone.curve=easy", "tone.curve=0,0", "tone.curve=0,0 0.0001,1",
                             "tone.curve=0,0 1,2", "tone.curve={"}) {
        const Outcome outcome = picture(sketch, {text});
        EXPECT_NE(outcome.exitCode, 0);
        EXPECT_NE(outcome.err.find("linear, ease, steps, or 2 to 16 points"), std::string::npos)
            << outcome.err;
    }
}

TEST(SetRamp, AnyForm_IsTaken) {
    const std::string usual = picture(cartoon, {"tones=ramp"}).out;
    for (const char* text : {"tone.ramp=constant 0:#203040 0.6:#ffddaa", "tone.ramp=0:0.1,0.2,0.3",
                             R"(tone.ramp={"stops": [{"at": 0, "color": [1, 0, 0]}]})"}) {
        const Outcome outcome = picture(cartoon, {"tones=ramp", text});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(outcome.out, usual) << text;
    }
}

TEST(SetRamp, WithoutTheChoice_ChangesNothing) {
    EXPECT_EQ(picture(cartoon, {"tone.ramp=0:#ff0000"}).out, picture(cartoon, {}).out);
}

struct BadValue {
    const char* name;
    const char* preset; ///< model's id
    const char* id;
    const char* json;
    const char* message; ///< with the column of the value, or of what is wrong in it
};

void PrintTo(const BadValue& bad, std::ostream* out) {
    *out << bad.name;
}

class BadValueInAPreset : public testing::TestWithParam<BadValue> {};

TEST_P(BadValueInAPreset, Message_SaysWhatAndWhere) {
    const TemporaryFolder folder;
    const std::string file = (folder / "p.patina.json").string();
    writeFile(file, std::string(
                        "{\"format\": \"patina.preset\", \"version\": 1,\n\"model\": {\"id\": \"") +
                        GetParam().preset + "\", \"version\": 1},\n\"parameters\": {\n  \"" +
                        GetParam().id + "\": " + GetParam().json + "}}\n");
    const Outcome outcome = patina({"validate", file});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find(std::string("p.patina.json:4:") + GetParam().message),
              std::string::npos)
        << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(
    All, BadValueInAPreset,
    testing::Values(
        BadValue{"NoCurve", "gooch", "tone.curve", "1",
                 "17: the number 1 stands here; expected a "
                 "curve: {\"points\""},
        BadValue{"OnePoint", "gooch", "tone.curve", R"({"points": [[0, 0]]})",
                 "17: 1 points stand here; expected 2 to 16 points"},
        BadValue{"PointsThatGoBack", "gooch", "tone.curve", R"({"points": [[1, 0], [0, 1]]})",
                 "37: point 2 of the curve has x = 0 after 1"},
        BadValue{"NoRamp", "toon", "tone.ramp", "[]",
                 "16: an array of 0 stands here; expected a "
                 "ramp: {\"stops\""},
        BadValue{"UnknownInterpolation", "toon", "tone.ramp",
                 R"({"interpolation": "cubic", "stops": [{"at": 0, "color": [0, 0, 0]}]})",
                 "34: the text \"cubic\" stands for a ramp's interpolation"},
        BadValue{"StopThatGoesBack", "toon", "tone.ramp",
                 R"({"stops": [{"at": 1, "color": [0, 0, 0]}, {"at": 0, "color": [1, 1, 1]}]})",
                 "58: stop 2 of the ramp is at 0 after 1"},
        BadValue{"StopWithoutAColour", "toon", "tone.ramp",
                 R"({"stops": [{"at": 0, "color": [0, 0, 0]}, {"at": 1}]})",
                 "58: an object stands for stop 2 of the ramp; expected a stop"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(ValidateCommand, PointOutsideItsRange_IsNamedAtItsPlace) {
    const TemporaryFolder folder;
    const std::string file = (folder / "p.patina.json").string();
    writeFile(file, R"({"format": "patina.preset", "version": 1,
"model": {"id": "gooch", "version": 1},
"parameters": {"tone.curve": {"points": [
    [0, 0],
    [1, 3]]}}})");
    const Outcome outcome = patina({"validate", file});
    EXPECT_NE(outcome.err.find("p.patina.json:5:5: point 2 of \"tone.curve\" is outside its range "
                               "and was brought into it; expected 0.0 to 1.0"),
              std::string::npos)
        << outcome.err;
}

TEST(ValidateCommand, BadStopOfAnObjectOfAScene_IsNamedAtItsPlace) {
    const TemporaryFolder folder;
    const std::string file = (folder / "s.patina-scene.json").string();
    writeFile(file, R"({"format": "patina.scene", "version": 1, "objects": [{
"preset": {"format": "patina.preset", "version": 1, "model": {"id": "toon", "version": 1},
"parameters": {"tone.ramp": {"stops": [
    {"at": 0.5, "color": [0, 0, 0]},
    {"at": 1.5, "color": [1, 1, 1]}]}}}}]})");
    const Outcome outcome = patina({"validate", file});
    EXPECT_NE(outcome.err.find(":5:5: stop 2 of the ramp is at 1.5; expected a place from 0 to 1"),
              std::string::npos)
        << outcome.err;
}

TEST(ModelsCommand, CurveAndRamp_AreListed) {
    const Outcome outcome = patina({"models"});
    EXPECT_NE(outcome.out.find("tone.curve               curve   0,0 1,1"), std::string::npos);
    EXPECT_NE(outcome.out.find("1 to 16 stops, colours 0 .. 1"), std::string::npos);
}

TEST(EffectsCommand, StraightCurve_IsNotInTheShader) {
    EXPECT_EQ(patina({"effects", sketch, "--no-cost", "--source"}).out.find("PARAMETER_DATA(at"),
              std::string::npos);
}

} // namespace
} // namespace patina::tests::curve_ramp_test
