// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests {
namespace {

const std::string gold = shipped("presets/cook-torrance/gold.patina.json").string();
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
    auto scene = nlohmann::json::parse(
        readFile(shipped("presets/default.patina-scene.json")));
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

TEST(EffectsCommand, List_NamesTheModel) {
    const Outcome outcome = patina({"effects", gold, "--no-cost"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("cook-torrance"), std::string::npos) << outcome.out;
}

TEST(EffectsCommand, Table_EndsWithTheWholeFrame) {
    const Outcome outcome = patina({"effects", gold, "--size", "32x32"});
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
} // namespace patina::tests
