// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs of files that CONTRIBUTING.md shows are blocks of their kinds, with no other edit.
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::new_block_test {
namespace {

using Json = nlohmann::json;

class NewBlock : public testing::Test {
  protected:
    void SetUp() override {
        const std::string guide = readFile(shipped("CONTRIBUTING.md"));
        static const std::regex block(
            "```(?:json|glsl) ((?:lights|fresnel|fog|pass|strokes|shells)/\\S+)\n([^`]*)```");
        for (std::sregex_iterator it(guide.begin(), guide.end(), block), end; it != end; ++it) {
            writeFile(data_ / ("patina/shaders/" + (*it)[1].str()), (*it)[2]);
            files_.push_back((*it)[1]);
        }
    }

    Outcome patinaWithThem(std::vector<std::string> arguments, std::string input = {}) {
        return patina(Start{.arguments = std::move(arguments),
                            .environment = {{"XDG_DATA_HOME", data_.path()}},
                            .input = std::move(input)});
    }

    /// The value of a case in the real shader.
    Json onTheGpu(Json request) {
        request["id"] = "a";
        request["precision"] = "gpu";
        const Outcome outcome = patinaWithThem({"eval"}, request.dump() + "\n");
        const Json answer = Json::parse(outcome.out, nullptr, false);
        EXPECT_TRUE(answer.contains("value")) << outcome.out << outcome.err;
        return answer;
    }

    std::vector<std::string> files_;
    TemporaryFolder data_;
};

TEST_F(NewBlock, Guide_HasTwoFilesOfEachKind) {
    EXPECT_EQ(files_, (std::vector<std::string>{
                          "lights/warn.json", "lights/warn.glsl", "fresnel/lazanyi.json",
                          "fresnel/lazanyi.glsl", "fog/haze.json", "fog/haze.glsl",
                          "pass/vignette.json", "pass/vignette.glsl", "strokes/dash.json",
                          "strokes/dash.glsl", "shells/bristle.json", "shells/bristle.glsl"}));
}

TEST_F(NewBlock, Descriptors_AreValid) {
    for (const std::string& file : files_) {
        if (file.ends_with(".json")) {
            const Outcome outcome =
                patinaWithThem({"validate", data_ / ("patina/shaders/" + file)});
            EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        }
    }
}

TEST_F(NewBlock, Scene_IsDrawnWithThem) {
    const std::string file = data_ / "all.patina-scene.json";
    Json scene = Json::parse(readFile(shipped("presets/three-lights.patina-scene.json")));
    scene["objects"][0]["preset"] = shipped("presets/cook-torrance/red-plastic.patina.json");
    scene["lights"] = Json::array({{{"name", "lamp"}, {"id", "warn"}}});
    scene["fog"] = {{"id", "haze"}, {"parameters", {{"density", 1.0}}}};
    scene["passes"] = Json::parse(R"([{"id": "vignette"}])");
    writeFile(file, scene.dump());
    const Outcome outcome = patinaWithThem({"effects", "--scene", file, "--no-cost"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("lights/warn"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("fog/haze"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("pass/vignette"), std::string::npos) << outcome.out;
    const std::string picture = data_ / "drawn.png";
    const Outcome drawn =
        patinaWithThem({"render", "--scene", file, "--size", "16x16", "-o", picture});
    EXPECT_EQ(drawn.exitCode, 0);
    EXPECT_EQ(drawn.err, "") << "the driver takes all shaders";
    EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST_F(NewBlock, WhatStandsOnASurface_IsDrawn) {
    Json scene = Json::parse(readFile(shipped("presets/three-lights.patina-scene.json")));
    const auto drawn = [&](const std::string& kind, const std::string& id) {
        Json preset =
            Json::parse(readFile(shipped("presets/cook-torrance/red-plastic.patina.json")));
        if (!kind.empty()) {
            preset[kind] = {{"id", id}};
        }
        scene["objects"][0]["preset"] = preset;
        const std::string file = data_ / "standing.patina-scene.json";
        const std::string picture = data_ / (id + ".png");
        writeFile(file, scene.dump());
        const Outcome outcome =
            patinaWithThem({"render", "--scene", file, "--size", "16x16", "-o", picture});
        EXPECT_EQ(outcome.exitCode, 0);
        EXPECT_EQ(outcome.err, "") << "the driver takes all shaders";
        return readFile(picture);
    };
    const std::string bare = drawn("", "bare");
    EXPECT_NE(drawn("strokes", "dash"), bare);
    EXPECT_NE(drawn("shells", "bristle"), bare);
}

TEST_F(NewBlock, FresnelOnTheGpu_GivesItsFormula) {
    // At 60 degrees: 0.5 + 0.5 / 32 - 0.6 * 0.5 / 64.
    const Json answer =
        onTheGpu({{"fresnel", {{"id", "lazanyi"}, {"parameters", {{"f0", {0.5, 0.5, 0.5}}}}}},
                  {"cos", 0.5}});
    EXPECT_NEAR(answer["value"][0].get<double>(), 0.5 + 0.5 / 32.0 - 0.3 / 64.0, 1e-6);
}

} // namespace
} // namespace patina::tests::new_block_test
