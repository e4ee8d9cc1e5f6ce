// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::check_test {
namespace {

/// A user's folder with a model of two files whose body is `body`.
class CheckCommand : public testing::Test {
  protected:
    void writeModel(const std::string& body) {
        writeFile(data_ / "patina/shaders/models/tried.json", R"({
            "id": "tried", "version": 1, "label": "Tried", "summary": "A test.",
            "applications": "None.", "source": "None.",
            "parameters": [{"id": "width", "label": "Width", "doc": "A width.", "type": "float",
                            "default": 0.5, "min": 0.0, "max": 1.0, "step": 0.01}],
            "claims": ["finite", "non_negative", "zero_below_horizon"]})");
        writeFile(data_ / "patina/shaders/models/tried.glsl",
                  "// SPDX-License-"
                  "Identifier: MIT-0\n#include \"lib/directions.glsl\"\n"
                  "vec3 tried(Directions d, Tried p) {\n    return " +
                      body + ";\n}\n");
    }

    void writeFog(const std::string& color);

    Outcome run(std::vector<std::string> arguments, std::string input = {}) {
        return patina(Start{.arguments = std::move(arguments),
                            .environment = {{"XDG_DATA_HOME", data_.path()}},
                            .input = std::move(input)});
    }

    nlohmann::json checkedJson() {
        return nlohmann::json::parse(run({"check", "tried", "--json", "--cases", "20000"}).out);
    }

    TemporaryFolder data_;
};

TEST_F(CheckCommand, SoundPreset_Succeeds) {
    const Outcome outcome =
        run({"check", shipped("presets/cook-torrance/gold.patina.json"), "--cases", "20000"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("nothing breaks"), std::string::npos);
}

TEST_F(CheckCommand, FewerCasesThanTheEdgesTake_AreToldBeforeTheyBegin) {
    writeModel("vec3(d.nl * p.width)");
    const Outcome few = run({"check", "tried", "--cases", "1", "--json"});
    const std::size_t done = nlohmann::json::parse(few.out)["cases"];
    EXPECT_TRUE(few.err.starts_with(std::to_string(done) + " cases, not 1: ")) << few.err;
    const Outcome enough = run({"check", "tried", "--cases", "60000"});
    EXPECT_EQ(enough.err.find(" cases, not "), std::string::npos) << enough.err;
}

TEST_F(CheckCommand, UnknownSubject_SaysWhatThereIs) {
    const Outcome outcome = run({"check", "lambrt"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("lambert"), std::string::npos) << outcome.err;
}

TEST_F(CheckCommand, ModelWithoutDoubleCode_SaysSoInTheVerdict) {
    writeModel("vec3(d.nl * p.width)");
    const Outcome outcome = run({"check", "tried", "--cases", "20000"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out;
    EXPECT_NE(outcome.out.find("on the graphics device only: nothing breaks"), std::string::npos)
        << outcome.out;
}

TEST_F(CheckCommand, ModelThatIsNoNumberAtGrazing_Fails) {
    writeModel("vec3(sqrt(d.nl - 1e-5))");
    EXPECT_EQ(run({"check", "tried", "--cases", "20000"}).exitCode, 1);
    const nlohmann::json found = checkedJson();
    ASSERT_EQ(found["defects"].size(), 1u) << found;
    EXPECT_EQ(found["defects"][0]["what"], "not a number");
    EXPECT_LE(found["defects"][0]["worst"]["case"]["l"][2].get<double>(), 1.1e-5);
}

TEST_F(CheckCommand, ModelThatIsNoNumberAtTheEndOfAParameter_Fails) {
    writeModel("vec3(d.nl * sin(p.width) / p.width)");
    const nlohmann::json found = checkedJson();
    ASSERT_FALSE(found["defects"].empty());
    EXPECT_EQ(found["defects"][0]["what"], "not a number");
    for (const nlohmann::json& defect : found["defects"]) {
        EXPECT_EQ(defect["worst"]["case"]["parameters"]["width"], 0.0) << defect;
    }
}

TEST_F(CheckCommand, NegativeValue_IsFoundThoughTheEngineCutsIt) {
    writeModel("vec3(d.nl - p.width)");
    const nlohmann::json found = checkedJson();
    ASSERT_EQ(found["defects"].size(), 1u) << found;
    EXPECT_EQ(found["defects"][0]["what"], "negative");
}

TEST_F(CheckCommand, BlocksOfAStructsFields_AreSound) {
    for (const char* block : {"environment/window-room", "refraction/solid-body",
                              "outline/ink-line", "transparency/weighted"}) {
        const Outcome outcome = run({"check", block, "--cases", "20000"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
        EXPECT_NE(outcome.out.find("nothing breaks"), std::string::npos) << block;
    }
}

TEST_F(CheckCommand, EnvironmentThatIsDarkerThanBlackBelow_Fails) {
    writeFile(data_ / "patina/shaders/environment/tried.json", R"({
        "id": "tried", "version": 1, "label": "Tried", "summary": "A test.",
        "applications": "None.", "source": "None.", "parameters": [],
        "claims": ["finite", "non_negative"]})");
    writeFile(data_ / "patina/shaders/environment/tried.glsl",
              "// SPDX-License-"
              "Identifier: MIT-0\n#include \"lib/outlook.glsl\"\n"
              "vec3 triedEnvironment(Outlook o, TriedEnvironment p) {\n"
              "    return vec3(o.d.y);\n}\n");
    const nlohmann::json found = checkedJson();
    ASSERT_EQ(found["defects"].size(), 1u) << found;
    EXPECT_EQ(found["defects"][0]["what"], "negative");
    EXPECT_LT(found["defects"][0]["worst"]["case"]["direction"][1].get<double>(), 0.0);
}

/// A user's fog whose colour is `color`.
void CheckCommand::writeFog(const std::string& color) {
    writeFile(data_ / "patina/shaders/fog/tried.json", R"({
        "id": "tried", "version": 1, "label": "Tried", "summary": "A test.",
        "applications": "None.", "source": "None.",
        "parameters": [{"id": "shade", "label": "Shade", "doc": "A shade.", "type": "float",
                        "default": 0.5, "min": 0.0, "max": 1.0, "step": 0.01}],
        "claims": ["finite", "non_negative"]})");
    writeFile(data_ / "patina/shaders/fog/tried.glsl",
              "// SPDX-License-"
              "Identifier: MIT-0\n#include \"lib/fog_ray.glsl\"\n"
              "float triedFog(FogRay ray, TriedFog p) {\n    return 0.5;\n}\n"
              "vec3 triedFogColor(TriedFog p) {\n    return vec3(" +
                  color + ");\n}\n");
}

TEST_F(CheckCommand, FogWhoseColorIsNoNumber_FailsAndNamesColor) {
    writeFog("log(p.shade - 2.0)");
    const Outcome outcome = run({"check", "fog/tried", "--cases", "20000"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.out.find("worst: Color\n"), std::string::npos) << outcome.out;
    const nlohmann::json found = checkedJson();
    ASSERT_EQ(found["defects"].size(), 1u) << found;
    const nlohmann::json line = found["defects"][0]["worst"]["case"];
    EXPECT_EQ(line["call"], "Color");
    EXPECT_NE(run({"eval"}, line.dump() + "\n").out.find("not finite"), std::string::npos);
}

TEST_F(CheckCommand, ColorThatBreaksAtTheEndOfAParameterOnly_Fails) {
    writeFog("sin(p.shade) / p.shade");
    const nlohmann::json found = checkedJson();
    ASSERT_EQ(found["defects"].size(), 1u) << found;
    EXPECT_EQ(found["defects"][0]["worst"]["case"]["fog"]["parameters"]["shade"], 0.0);
}

TEST_F(CheckCommand, FogWithASoundColor_Succeeds) {
    writeFog("p.shade");
    const Outcome outcome = run({"check", "fog/tried", "--cases", "20000"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out;
}

TEST_F(CheckCommand, WayOfAnyLength_IsTried) {
    writeFile(data_ / "patina/shaders/refraction/tried.json", R"({
        "id": "tried", "version": 1, "label": "Tried", "summary": "A test.",
        "applications": "None.", "source": "None.",
        "parameters": [{"id": "index", "label": "Index", "doc": "Bends.", "type": "float",
                        "role": "index",
                        "default": 1.5, "min": 1.0, "max": 3.0, "step": 0.01}],
        "claims": ["finite", "non_negative"]})");
    writeFile(data_ / "patina/shaders/refraction/tried.glsl",
              "// SPDX-License-"
              "Identifier: MIT-0\n#include \"lib/crossing.glsl\"\n"
              "vec3 triedRefraction(Crossing c, TriedRefraction p) {\n    return -c.l;\n}\n"
              "float triedRefractionMirrored(Crossing c, TriedRefraction p) {\n"
              "    return 0.0;\n}\n"
              "vec3 triedRefractionLeft(float way, TriedRefraction p) {\n"
              "    return vec3(way > 1e5 ? -1.0 : 1.0);\n}\n");
    const nlohmann::json found = checkedJson();
    ASSERT_EQ(found["defects"].size(), 1u) << found;
    EXPECT_EQ(found["defects"][0]["worst"]["case"]["call"], "Left");
    EXPECT_GT(found["defects"][0]["worst"]["case"]["way"].get<double>(), 1e5);
}

TEST_F(CheckCommand, WorstCase_IsALineForEval) {
    writeModel("vec3(sqrt(d.nl - 1e-5))");
    const std::string line = checkedJson()["defects"][0]["worst"]["case"].dump() + "\n";
    const Outcome outcome = run({"eval"}, line);
    EXPECT_NE(outcome.out.find("not finite"), std::string::npos) << outcome.out;
}

TEST_F(CheckCommand, ModelThatDoesNotCompile_Fails) {
    writeModel("vec3(d.nosuch)");
    const Outcome outcome = run({"check", "tried", "--cases", "20000"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.out.find("tried.glsl:4"), std::string::npos) << outcome.out;
}

TEST_F(CheckCommand, InterruptedBeforeAnythingIsFound_HasAStatusOfItsOwn) {
    const Outcome outcome = interrupted({"check", "he-torrance", "--cases", "100000000"});
    EXPECT_EQ(outcome.exitCode, 130) << outcome.err;
    EXPECT_NE(outcome.err.find("stopped"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::check_test
