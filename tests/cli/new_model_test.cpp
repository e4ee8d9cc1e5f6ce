// SPDX-License-Identifier: GPL-3.0-or-later
// The two files that CONTRIBUTING.md works through are a lighting model, with no other edit.
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::new_model_test {
namespace {

class NewModel : public testing::Test {
  protected:
    void SetUp() override {
        const std::string guide = readFile(shipped("CONTRIBUTING.md"));
        static const std::regex block("```(?:json|glsl) (models/\\S+)\n([^`]*)```");
        for (std::sregex_iterator it(guide.begin(), guide.end(), block), end; it != end; ++it) {
            writeFile(data_ / ("patina/shaders/" + (*it)[1].str()), (*it)[2]);
            ++files_;
        }
    }

    Outcome patinaWithIt(std::vector<std::string> arguments, std::string input = {}) {
        return patina(Start{.arguments = std::move(arguments),
                            .environment = {{"XDG_DATA_HOME", data_.path()}},
                            .input = std::move(input)});
    }

    std::string descriptor() { return data_ / "patina/shaders/models/wrap-lambert.json"; }

    int files_ = 0;
    TemporaryFolder data_;
};

TEST_F(NewModel, Guide_HasTwoFiles) {
    EXPECT_EQ(files_, 2);
}

TEST_F(NewModel, Descriptor_IsValid) {
    const Outcome outcome = patinaWithIt({"validate", descriptor()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
}

TEST_F(NewModel, Models_ListIt) {
    const Outcome outcome = patinaWithIt({"models"});
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("wrap-lambert"), std::string::npos);
}

TEST_F(NewModel, Models_AreWithoutItElsewhere) {
    EXPECT_EQ(patina({"models"}).out.find("wrap-lambert"), std::string::npos);
}

TEST_F(NewModel, ModelsJson_HasItsParameters) {
    bool found = false;
    for (const auto& block : nlohmann::json::parse(patinaWithIt({"models", "--json"}).out)) {
        if (block["id"] == "wrap-lambert") {
            found = true;
            EXPECT_EQ(block["parameters"].size(), 2u);
        }
    }
    EXPECT_TRUE(found);
}

TEST_F(NewModel, Render_DrawsIt) {
    const Outcome outcome =
        patinaWithIt({"render", "--model", "wrap-lambert", "--size", "64x64", "-o", "-"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("\x89PNG"));
}

TEST_F(NewModel, Render_FollowsItsParameter) {
    const auto picture = [&](const std::string& wrap) {
        return patinaWithIt({"render", "--model", "wrap-lambert", "--set", "wrap=" + wrap, "--size",
                             "64x64", "-o", "-"})
            .out;
    };
    EXPECT_FALSE(picture("0") == picture("1"));
}

TEST_F(NewModel, EffectsSource_HasItsFunction) {
    const Outcome outcome = patinaWithIt({"effects", "--model", "wrap-lambert", "--source"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("vec3 wrapLambert(Directions d, WrapLambert p)"), std::string::npos);
}

TEST_F(NewModel, EvalOnTheGpu_GivesItsFormula) {
    // Light at 60 degrees, wrap 0.5: (0.5 + 0.5) / 1.5.
    const Outcome outcome =
        patinaWithIt({"eval"}, R"({"id": "a", "model": "wrap-lambert", "parameters":)"
                               R"( {"diffuse.color": [1, 1, 1], "wrap": 0.5},)"
                               R"( "l": [0.866025403784, 0, 0.5], "v": [0, 0, 1],)"
                               R"( "precision": "gpu"})"
                               "\n");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto answer = nlohmann::json::parse(outcome.out);
    ASSERT_TRUE(answer.contains("value")) << outcome.out;
    EXPECT_NEAR(answer["value"][0].get<double>(), 1.0 / 1.5, 1e-6);
}

TEST_F(NewModel, EvalOnTheGpu_CutsANegativeValueAtZero) {
    writeFile(data_ / "patina/shaders/models/wrap-lambert.glsl",
              "// SPDX-License-"
              "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
              "vec3 wrapLambert(Directions d, WrapLambert p) {\n    return vec3(-0.5);\n}\n");
    const Outcome outcome = patinaWithIt({"eval"}, R"({"id": "a", "model": "wrap-lambert",)"
                                                   R"( "l": [0, 0, 1], "v": [0, 0, 1],)"
                                                   R"( "precision": "gpu"})"
                                                   "\n");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.out;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["value"], (std::vector<double>{0.0, 0.0, 0.0}))
        << outcome.out;
}

} // namespace
} // namespace patina::tests::new_model_test
