// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::check_test {
namespace {

constexpr const char* soundClaims = R"("finite", "non_negative")";

/// A user's folder with one block of two files.
class CheckCommand : public testing::Test {
  protected:
    /// A block of the user's, "tried".
    void write(const std::string& kind, const std::string& parameters, const std::string& claims,
               const std::string& glsl) {
        const std::string file = "patina/shaders/" + kind + "/tried";
        writeFile(data_ / (file + ".json"), R"({
            "id": "tried", "version": 1, "label": "Tried", "summary": "A test.",
            "applications": "None.", "source": "None.", "parameters": [)" +
                                                parameters + R"(], "claims": [)" + claims + "]}");
        writeFile(data_ / (file + ".glsl"), "// SPDX-License-"
                                            "Identifier: MIT-0\n" +
                                                glsl);
    }

    void writeModel(const std::string& body) {
        write("models", shareCalled("width"), R"("finite", "non_negative", "zero_below_horizon")",
              "#include \"lib/directions.glsl\"\n"
              "vec3 tried(Directions d, Tried p) {\n    return " +
                  body + ";\n}\n");
    }

    /// A parameter from 0 to 1.
    static std::string shareCalled(const std::string& id) {
        return R"({"id": ")" + id + R"(", "label": "Share", "doc": "A share.", "type": "float",
                  "default": 0.5, "min": 0.0, "max": 1.0, "step": 0.01})";
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

TEST_F(CheckCommand, FewerCasesThanTheEdgesTake_BoundTheSweepAndAreTold) {
    writeModel("vec3(d.nl * p.width)");
    const Outcome few = run({"check", "tried", "--cases", "100", "--json"});
    const std::size_t done = nlohmann::json::parse(few.out)["cases"];
    EXPECT_LE(done, 100u);
    EXPECT_GT(done, 80u);
    EXPECT_TRUE(few.err.starts_with(std::to_string(done) + " cases; ")) << few.err;
    const Outcome enough = run({"check", "tried", "--cases", "60000"});
    EXPECT_EQ(enough.err.find("left out"), std::string::npos) << enough.err;
}

TEST_F(CheckCommand, OneCase_IsTriedOfEachProgram) {
    const Outcome outcome = run({"check", "lambert", "--cases", "1", "--json"});
    const nlohmann::json found = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(found["cases"], found["programs"]) << outcome.out;
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
    write("environment", "", soundClaims,
          "#include \"lib/sky_ray.glsl\"\n"
          "vec3 triedEnvironment(SkyRay o, TriedEnvironment p) {\n"
          "    return vec3(o.d.y);\n}\n");
    const nlohmann::json found = checkedJson();
    ASSERT_EQ(found["defects"].size(), 1u) << found;
    EXPECT_EQ(found["defects"][0]["what"], "negative");
    EXPECT_LT(found["defects"][0]["worst"]["case"]["direction"][1].get<double>(), 0.0);
}

/// A user's fog whose colour is `color`.
void CheckCommand::writeFog(const std::string& color) {
    write("fog", shareCalled("shade"), soundClaims,
          "#include \"lib/fog_ray.glsl\"\n"
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
    write("refraction",
          R"({"id": "index", "label": "Index", "doc": "Bends.", "type": "float", "role": "index",
              "default": 1.5, "min": 1.0, "max": 3.0, "step": 0.01})",
          soundClaims,
          "#include \"lib/interface.glsl\"\n"
          "vec3 triedRefraction(Interface c, TriedRefraction p) {\n    return -c.l;\n}\n"
          "float triedRefractionMirrored(Interface c, TriedRefraction p) {\n"
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
