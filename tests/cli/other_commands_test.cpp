// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::other_commands_test {
namespace {

const std::string plastic = shipped("presets/strauss/red-plastic.patina.json").string();

Outcome eval(const std::string& lines) {
    return patina(Start{.arguments = {"eval"}, .environment = {}, .input = lines});
}

TEST(Program, UnknownOption_FailsOnStandardError) {
    const Outcome outcome = patina({"models", "--no-such-option"});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("--no-such-option"), std::string::npos) << outcome.err;
}

TEST(Program, MisspeltCommand_IsNotTakenForAFile) {
    const Outcome outcome = patina({"rendr", gold});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("rendr"), std::string::npos) << outcome.err;
}

TEST(Program, Help_NamesEveryCommand) {
    const Outcome outcome = patina({"--help"});
    EXPECT_EQ(outcome.exitCode, 0);
    for (const char* name : {"render", "compare", "effects", "eval", "validate", "models"}) {
        EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
    }
}

TEST(Program, EditorWithoutADisplay_SaysSoAndExitsWithOne) {
    const Outcome outcome = patina(std::vector<std::string>{});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("display"), std::string::npos) << outcome.err;
}

TEST(CompareCommand, TwoPresets_WriteAPicture) {
    const TemporaryFolder folder;
    const Outcome outcome = patina({"compare", gold, plastic, "--mode", "side", "--size", "96x64",
                                    "-o", (folder / "a.png").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(readFile(folder / "a.png").starts_with("\x89PNG"));
}

TEST(CompareCommand, Flip_IsZeroForTheSamePictureOnly) {
    const TemporaryFolder folder;
    const Outcome outcome = patina(
        {"compare", gold, plastic, gold, "--size", "96x64", "-o", (folder / "a.png").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::size_t plasticAt = outcome.out.find("FLIP 0.");
    const std::size_t goldAt = outcome.out.find("FLIP 0.00000", plasticAt + 1);
    ASSERT_NE(plasticAt, std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.substr(plasticAt, 12), "FLIP 0.00000");
    EXPECT_NE(goldAt, std::string::npos) << outcome.out;
}

TEST(CompareCommand, Page_HoldsBothPicturesAndLoadsNothing) {
    const TemporaryFolder folder;
    const Outcome outcome =
        patina({"compare", gold, plastic, "--size", "96x64", "-o", (folder / "a.html").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string page = readFile(folder / "a.html");
    std::size_t pictures = 0;
    constexpr std::string_view picture = "src=\"data:image/png;base64,iVBORw0KGgo";
    for (std::size_t at = page.find(picture); at != std::string::npos;
         at = page.find(picture, at + 1)) {
        ++pictures;
    }
    EXPECT_EQ(pictures, 2u);
    EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
    EXPECT_EQ(page.find("http://"), std::string::npos);
    EXPECT_EQ(page.find("https://"), std::string::npos);
}

TEST(CompareCommand, MissingPreset_ExitsWithOne) {
    const Outcome outcome = patina({"compare", gold, "missing.patina.json", "-o", "-"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("missing.patina.json"), std::string::npos) << outcome.err;
}

TEST(EffectsCommand, Source_HasNoFogWithoutFog) {
    const Outcome outcome = patina({"effects", gold, "--source"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("#version"), std::string::npos);
    EXPECT_EQ(outcome.out.find("fog"), std::string::npos);
}

/// The table says that it changes no pixel of what is seen.
TEST(EffectsCommand, Source_HasNoFogThatTheTableSaysIsOut) {
    auto scene = nlohmann::json::parse(readFile(shipped("presets/three-lights.patina-scene.json")));
    scene["fog"] = {{"id", "exponential"}, {"parameters", {{"density", 1e-7}}}};
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "thin.patina-scene.json";
    std::ofstream(file) << scene.dump();
    const std::vector<std::string> thin{"effects", gold, "--scene", file.string()};
    std::vector<std::string> table = thin;
    table.emplace_back("--no-cost");
    EXPECT_NE(patina(table).out.find("it changes no pixel"), std::string::npos);
    std::vector<std::string> source = thin;
    source.emplace_back("--source");
    const Outcome outcome = patina(source);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("#version"), std::string::npos);
    EXPECT_EQ(outcome.out.find("fog"), std::string::npos);
}

/// A scene of two objects: a Lambert ball and a Phong ball.
class EffectsOfObjects : public testing::Test {
  protected:
    EffectsOfObjects() {
        auto scene =
            nlohmann::json::parse(readFile(shipped("presets/three-lights.patina-scene.json")));
        auto& objects = scene["objects"];
        objects.push_back(objects[0]);
        const std::array<const char*, 2> names{"Left", "Right"};
        const std::array<const char*, 2> models{"lambert", "phong"};
        for (std::size_t i = 0; i < 2; ++i) {
            objects[i]["name"] = names[i];
            objects[i]["preset"] = {
                {"format", "patina.preset"}, {"version", 1}, {"model", {{"id", models[i]}}}};
        }
        writeFile(file(), scene.dump());
    }

    std::string file() const { return folder_ / "two.patina-scene.json"; }

    Outcome effects(std::vector<std::string> more) const {
        more.insert(more.begin(), {"effects", "--scene", file(), "--no-cost"});
        return patina(more);
    }

    TemporaryFolder folder_;
};

TEST_F(EffectsOfObjects, Unasked_AreThoseOfTheFirst) {
    const Outcome outcome = effects({});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("Left, object 1 of 2\n")) << outcome.out;
    EXPECT_NE(outcome.out.find("models/lambert"), std::string::npos) << outcome.out;
}

TEST_F(EffectsOfObjects, NameOrNumber_ChoosesOne) {
    for (const char* wanted : {"Right", "2"}) {
        const Outcome outcome = effects({"--object", wanted});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_TRUE(outcome.out.starts_with("Right, object 2 of 2\n")) << outcome.out;
        EXPECT_NE(outcome.out.find("models/phong"), std::string::npos) << outcome.out;
    }
    const Outcome source = effects({"--object", "Right", "--source"});
    EXPECT_NE(source.out.find("phong("), std::string::npos);
    EXPECT_TRUE(source.out.starts_with("// Right, object 2 of 2\n"));
}

TEST_F(EffectsOfObjects, Json_SaysWhichObjectItIs) {
    const Outcome outcome = effects({"--object", "2", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["object"]["name"], "Right");
    EXPECT_EQ(json["object"]["number"], 2);
    EXPECT_EQ(json["object"]["count"], 2);
}

TEST_F(EffectsOfObjects, UnknownObject_IsAnError) {
    for (const char* wanted : {"Middle", "0", "3", "-1", "2x", "99999999999999999999999"}) {
        const Outcome outcome = effects({std::string("--object=") + wanted});
        EXPECT_EQ(outcome.exitCode, 1) << wanted;
        EXPECT_NE(outcome.err.find("the scene has no such object"), std::string::npos)
            << outcome.err;
        EXPECT_NE(outcome.err.find("a number from 1 to 2"), std::string::npos) << outcome.err;
    }
}

/// Neither the first one, nor one that has no name.
TEST_F(EffectsOfObjects, EmptyName_IsAnError) {
    auto scene = nlohmann::json::parse(readFile(file()));
    scene["objects"][1]["name"] = "";
    writeFile(file(), scene.dump());
    const Outcome outcome = effects({"--object", ""});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("the scene has no such object"), std::string::npos) << outcome.err;
}

/// There is none; the table says why.
TEST_F(EffectsOfObjects, SourceOfWhatIsNotDrawn_IsAnErrorThatSaysWhy) {
    auto scene = nlohmann::json::parse(readFile(file()));
    scene["objects"][0]["visible"] = false;
    scene["objects"][1]["translation"] = {1000, 0, 0};
    writeFile(file(), scene.dump());
    for (const auto& [object, why] : {std::pair("1", "The object is hidden."),
                                      std::pair("2", "The object is outside the view")}) {
        EXPECT_NE(effects({"--object", object}).out.find(why), std::string::npos);
        for (const char* option : {"--source", "--json"}) {
            const Outcome outcome = effects({"--object", object, "--source", option});
            EXPECT_EQ(outcome.exitCode, 1);
            EXPECT_EQ(outcome.out, "");
            EXPECT_NE(outcome.err.find(why), std::string::npos) << outcome.err;
        }
    }
}

TEST_F(EffectsOfObjects, SourceAsJson_StandsBesideTheList) {
    const Outcome outcome = effects({"--source", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_FALSE(json["effects"].empty());
    EXPECT_TRUE(json["vertex"].get<std::string>().starts_with("#version"));
    EXPECT_TRUE(json["fragment"].get<std::string>().starts_with("#version"));
}

TEST_F(EffectsOfObjects, NameThatTwoHave_AsksForANumber) {
    auto scene = nlohmann::json::parse(readFile(file()));
    scene["objects"][0]["name"] = "Right";
    writeFile(file(), scene.dump());
    const Outcome outcome = effects({"--object", "Right"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("2 objects are called so"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("1, 2"), std::string::npos) << outcome.err;
}

/// Fewer frames than tell anything for certain are drawn in so short a time.
TEST(EffectsCommand, SlowFrames_AreDrawnSmallerUnlessTheSizeIsGiven) {
    const std::vector<std::string> slow{"effects", "--model",   "lambert",
                                        "--json",  "--seconds", "0.001"};
    const auto pixelsOf = [](const std::vector<std::string>& command) {
        const Outcome outcome = patina(command);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("--seconds 0.001 is too short"), std::string::npos)
            << outcome.err;
        const auto costs = nlohmann::json::parse(outcome.out)["costs"];
        EXPECT_LT(costs["pairs"], 7);
        EXPECT_GT(costs["secondsNeeded"], 0.001);
        return costs["size"][0].get<int>();
    };
    EXPECT_LT(pixelsOf(slow), 384);
    std::vector<std::string> sized = slow;
    sized.insert(sized.end(), {"--size", "80x80"});
    EXPECT_EQ(pixelsOf(sized), 80);
}

/// Before anything is drawn, in every command that takes one.
TEST(Program, NumbersThatAreNone_AreRefused) {
    const TemporaryFolder folder;
    const std::string picture = (folder / "a.png").string();
    const std::vector<std::vector<std::string>> commands{
        {"effects", "--model", "lambert", "--seconds"},
        {"cost", "--model", "lambert", "--seconds"},
        {"cost", "--model", "lambert", "--budget-ms"},
        {"cost", "--model", "lambert", "--budget-error"},
        {"cost", "--model", "lambert", "--exposure"},
        {"render", "--model", "lambert", "-o", picture, "--exposure"},
        {"render", "--model", "lambert", "-o", picture, "--samples"},
        {"render", "--model", "lambert", "-o", picture, "--size"},
        {"compare", gold, plastic, "-o", picture, "--exposure"},
        {"compare", gold, plastic, "-o", picture, "--samples"},
        {"check", "lambert", "--cases"}};
    for (const std::vector<std::string>& command : commands) {
        for (const char* text : {"nan", "inf", "-inf", "1e999", "-1000000", "", "2x"}) {
            std::vector<std::string> arguments = command;
            arguments.back() += std::string("=") + text;
            const Outcome outcome = patina(arguments);
            EXPECT_NE(outcome.exitCode, 0) << command[0] << ' ' << arguments.back();
            EXPECT_EQ(outcome.out, "") << command[0] << ' ' << arguments.back();
            EXPECT_NE(outcome.err.find(command.back()), std::string::npos) << outcome.err;
        }
    }
    EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(EffectsCommand, NoTime_IsRefused) {
    const Outcome outcome = patina({"effects", "--model", "lambert", "--seconds", "0"});
    EXPECT_NE(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("seconds above 0"), std::string::npos) << outcome.err;
}

TEST(EffectsCommand, List_NamesTheModel) {
    const Outcome outcome = patina({"effects", gold, "--no-cost"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("cook-torrance"), std::string::npos) << outcome.out;
}

TEST(EffectsCommand, Table_EndsWithTheWholeFrame) {
    const std::string scene = shipped("presets/three-lights.patina-scene.json").string();
    const Outcome outcome = patina({"effects", gold, "--scene", scene, "--size", "32x32"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("the whole frame"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("32 x 32 pixels"), std::string::npos) << outcome.out;
}

TEST(EffectsCommand, Json_AddsUpToTheFrame) {
    const Outcome outcome = patina({"effects", gold, "--size", "32x32", "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    double sum = json["costs"]["rest"];
    for (const auto& effect : json["effects"]) {
        if (effect["within"] == "" && effect.contains("milliseconds") && !effect["belowNoise"]) {
            sum += effect["milliseconds"]["median"].get<double>();
        }
    }
    EXPECT_NEAR(sum, json["costs"]["frame"]["median"].get<double>(), 1e-9);
}

TEST(EffectsCommand, WhatIsNotIn_SaysWhy) {
    const Outcome outcome = patina({"effects", gold, "--no-cost"});
    EXPECT_NE(outcome.out.find("The scene has no fog."), std::string::npos) << outcome.out;
}

TEST(EffectsCommand, Source_MarksTheFilesOfEffects) {
    const Outcome outcome = patina({"effects", gold, "--source"});
    EXPECT_NE(outcome.out.find("// ---- models/cook-torrance.glsl: effect models/cook-torrance."),
              std::string::npos)
        << outcome.out;
}

TEST(EffectsCommand, PresetsModelInAnother_LetsTheFillingOfItsSlotRest) {
    const Outcome outcome = patina({"effects", gold, "--model", "lambert", "--no-cost"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("lambert"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("fresnel/"), std::string::npos) << outcome.out;
}

TEST(EvalCommand, WhiteLambertFacingTheLight_IsOne) {
    const Outcome outcome = eval(R"({"id": "a", "model": "lambert", "parameters":)"
                                 R"( {"diffuse.color": [1, 1, 1]}, "l": [0, 0, 1],)"
                                 R"( "v": [0, 0, 1], "precision": "double"})"
                                 "\n");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["value"], nlohmann::json({1.0, 1.0, 1.0}));
}

TEST(EvalCommand, BadLine_DoesNotStopTheNext) {
    const std::string good = R"({"id": "b", "fresnel": {"id": "schlick"}, "cos": 1})";
    const Outcome outcome = eval("this is no JSON\n" + good + "\n");
    EXPECT_NE(outcome.out.find("\"error\""), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("\"value\""), std::string::npos) << outcome.out;
}

TEST(EvalCommand, OneCasePerLine_AnswersOneLineEach) {
    const std::string line = R"({"id": "b", "fresnel": {"id": "schlick"}, "cos": 0.5})"
                             "\n";
    const std::string out = eval(line + line + line).out;
    EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 3) << out;
}

TEST(EvalCommand, Gpu_AgreesWithDouble) {
    const std::string common = R"({"id": "a", "model": "strauss", "l": [0.6, 0, 0.8],)"
                               R"( "v": [-0.48, 0, 0.87], "precision": ")";
    const auto value = [&](const std::string& precision) {
        const Outcome outcome = eval(common + precision + "\"}\n");
        return nlohmann::json::parse(outcome.out)["value"][0].get<double>();
    };
    EXPECT_NEAR(value("gpu") / value("double"), 1.0, 1e-4);
}

} // namespace
} // namespace patina::tests::other_commands_test
