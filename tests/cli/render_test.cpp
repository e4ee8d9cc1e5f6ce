// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/patina_program.h"

namespace patina::tests::render_test {
namespace {

const std::string pngSignature = "\x89PNG\r\n\x1a\n";
const std::string exrSignature = "\x76\x2f\x31\x01";

/// Big-endian number in a PNG header: width at 16, height at 20.
int pngNumber(const std::string& png, std::size_t at) {
    int number = 0;
    for (std::size_t i = at; i < at + 4 && i < png.size(); ++i) {
        number = number * 256 + static_cast<unsigned char>(png[i]);
    }
    return number;
}

TEST(RenderCommand, Preset_WritesAPng) {
    const TemporaryFolder folder;
    const Outcome outcome =
        patina({"render", gold, "--size", "64x48", "-o", (folder / "a.png").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(readFile(folder / "a.png").starts_with(pngSignature));
}

/// Whatever the scene's exposure is.
TEST(RenderCommand, AutoExposure_ChoosesTheSameForDarkAndBrightPictures) {
    const auto drawn = [](std::vector<std::string> more) {
        std::vector<std::string> arguments{"render", gold, "--size", "32x32", "-o", "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = patina(arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.out;
    };
    const std::string chosen = drawn({"--auto-exposure"});
    EXPECT_EQ(drawn({"--auto-exposure", "--set", "scene.exposure=5"}), chosen);
    EXPECT_NE(drawn({"--set", "scene.exposure=5"}), chosen);
}

TEST(RenderCommand, Preset_WritesNothingElse) {
    const TemporaryFolder folder;
    const Outcome outcome =
        patina({"render", gold, "--size", "64x48", "-o", (folder / "a.png").string()});
    EXPECT_EQ(outcome.out + outcome.err, "");
}

TEST(RenderCommand, MeshWithATriangleThatCannotBeDrawn_IsDrawnWithARemark) {
    const TemporaryFolder folder;
    const std::string mesh = (folder / "nan.obj").string();
    writeFile(mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 1 2 4\n");
    const Outcome outcome = patina({"render", gold, "--mesh", mesh, "--size", "32x32", "-o", "-"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("nan.obj: 1 of 2 triangles"), std::string::npos) << outcome.err;
}

TEST(RenderCommand, SceneWithShadows_IsDrawnWithThem) {
    const TemporaryFolder folder;
    auto scene = nlohmann::json::parse(readFile(shipped("presets/three-lights.patina-scene.json")));
    scene["objects"][0]["preset"] = nlohmann::json::parse(readFile(gold));
    const auto picture = [&folder, &scene] {
        writeFile(folder / "a.patina-scene.json", scene.dump());
        const Outcome outcome =
            patina({"render", "--scene", (folder / "a.patina-scene.json").string(), "--size",
                    "48x48", "-o", "-"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    };
    const std::string without = picture();
    scene["lights"][0]["shadow"] = {{"id", "soft"}, {"version", 1}};
    const std::string onItself = picture();
    EXPECT_NE(onItself, without);
    scene["ground"] = {{"mode", "shadows"}};
    EXPECT_NE(picture(), onItself);
}

TEST(RenderCommand, Turntable_WritesANumberedSeriesOfDifferentPictures) {
    const TemporaryFolder folder;
    const Outcome outcome = patina({"render", gold, "--mesh", "builtin:cube", "--size", "32x32",
                                    "--turntable", "3", "-o", (folder / "turn.png").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const std::string first = readFile(folder / "turn.0001.png");
    EXPECT_TRUE(first.starts_with(pngSignature));
    EXPECT_NE(readFile(folder / "turn.0002.png"), first);
    EXPECT_NE(readFile(folder / "turn.0003.png"), first);
    EXPECT_FALSE(std::filesystem::exists(folder / "turn.0004.png"));
    EXPECT_EQ(patina({"render", gold, "--mesh", "builtin:cube", "--size", "32x32", "-o", "-"}).out,
              first);
}

TEST(RenderCommand, TurntableOfLights_TurnsThemOnly) {
    const TemporaryFolder folder;
    const std::string scene = shipped("presets/three-lights.patina-scene.json").string();
    const Outcome outcome =
        patina({"render", "--scene", scene, "--mesh", "builtin:sphere", "--size", "32x32",
                "--turntable", "2", "--turn", "light", "-o", (folder / "turn.png").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(readFile(folder / "turn.0001.png"), readFile(folder / "turn.0002.png"));
}

TEST(RenderCommand, TurntableOfAnEnvironmentThatIsNotThere_IsAnError) {
    const TemporaryFolder folder;
    const std::string scene = shipped("presets/three-lights.patina-scene.json").string();
    const Outcome outcome =
        patina({"render", "--scene", scene, "--size", "32x32", "--turntable", "2", "--turn",
                "environment", "-o", (folder / "turn.png").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("environment"), std::string::npos) << outcome.err;
}

TEST(RenderCommand, TurntableToStandardOutput_IsAnError) {
    const Outcome outcome = patina({"render", gold, "--turntable", "2", "-o", "-"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("series of files"), std::string::npos) << outcome.err;
}

TEST(RenderCommand, Highlight_IsChosenAndSet) {
    const auto picture = [](std::vector<std::string> more) {
        std::vector<std::string> arguments{"render", "--model", "lambert", "--size",
                                           "32x32",  "-o",      "-"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return patina(arguments).out;
    };
    const std::string matte = picture({});
    const std::string glossy = picture({"--specular", "phong"});
    EXPECT_NE(glossy, matte);
    EXPECT_EQ(picture({"--set", "specular=phong"}), glossy);
    EXPECT_NE(picture({"--specular", "phong", "--set", "specular.shininess=3"}), glossy);
}

/// The shipped scene of three lights without its object.
std::filesystem::path emptyScene(const TemporaryFolder& folder) {
    auto json = nlohmann::json::parse(readFile(shipped("presets/three-lights.patina-scene.json")));
    json["objects"] = nlohmann::json::array();
    writeFile(folder / "empty.patina-scene.json", json.dump());
    return folder / "empty.patina-scene.json";
}

TEST(RenderCommand, EmptyScene_IsItsBackground) {
    const TemporaryFolder folder;
    const Outcome outcome =
        patina({"render", "--scene", emptyScene(folder), "--size", "32x32", "-o", "-"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with(pngSignature));
}

TEST(RenderCommand, EmptyScene_SaysThatItIs) {
    const TemporaryFolder folder;
    const std::string scene = emptyScene(folder);
    const Outcome outcome = patina({"render", "--scene", scene, "--size", "32x32", "-o", "-"});
    EXPECT_EQ(outcome.err, scene + ": the scene shows no object\n");
}

TEST(RenderCommand, HomeThatIsNoPath_GetsNothingIntoTheWorkingFolder) {
    const std::string home = "home-that-is-no-path";
    patina(Start{.arguments = {"render", "--model", "lambert", "--size", "8x8", "-o", "-"},
                 .environment = {{"HOME", home}, {"XDG_CACHE_HOME", ""}},
                 .input = {}});
    EXPECT_FALSE(std::filesystem::exists(home));
}

TEST(RenderCommand, PresetInAnEmptyScene_HasAnObject) {
    const TemporaryFolder folder;
    const std::string scene = emptyScene(folder);
    const std::string empty =
        patina({"render", "--scene", scene, "--size", "32x32", "-o", "-"}).out;
    const std::string shown =
        patina({"render", gold, "--scene", scene, "--size", "32x32", "-o", "-"}).out;
    EXPECT_TRUE(shown.starts_with(pngSignature));
    EXPECT_NE(shown, empty);
}

TEST(RenderCommand, Size_IsThePicturesSize) {
    const std::string png = patina({"render", gold, "--size", "64x48", "-o", "-"}).out;
    EXPECT_EQ(std::pair(pngNumber(png, 16), pngNumber(png, 20)), std::pair(64, 48));
}

TEST(RenderCommand, OutputDash_WritesThePngToStandardOutput) {
    const Outcome outcome = patina({"render", gold, "--size", "32x32", "-o", "-"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with(pngSignature));
}

TEST(RenderCommand, ExrExtension_WritesAnExr) {
    const TemporaryFolder folder;
    const Outcome outcome =
        patina({"render", gold, "--size", "32x32", "-o", (folder / "a.exr").string()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(readFile(folder / "a.exr").starts_with(exrSignature));
}

/// Views in place of the picture differ from it and from each other.
TEST(RenderCommand, Show_DrawsSomethingElse) {
    std::set<std::string> pictures;
    for (const char* shown : {"fresnel", "coordinates", "light=key"}) {
        const Outcome outcome =
            patina({"render", gold, "--size", "24x24", "--show", shown, "-o", "-"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        pictures.insert(outcome.out);
    }
    pictures.insert(patina({"render", gold, "--size", "24x24", "-o", "-"}).out);
    EXPECT_EQ(pictures.size(), 4U);
}

TEST(RenderCommand, Set_ChangesThePicture) {
    const std::vector<std::string> plain = {"render", gold, "--size", "32x32", "-o", "-"};
    std::vector<std::string> rough = plain;
    rough.insert(rough.end(), {"--set", "roughness=0.8"});
    EXPECT_FALSE(patina(plain).out == patina(rough).out);
}

TEST(RenderCommand, SameTwice_GivesTheSameBytes) {
    const std::vector<std::string> command = {"render", gold, "--size", "32x32", "-o", "-"};
    EXPECT_TRUE(patina(command).out == patina(command).out);
}

TEST(RenderCommand, ImportedMesh_IsDrawn) {
    const TemporaryFolder folder;
    writeFile(folder / "triangle.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome outcome = patina({"render", gold, "--mesh", (folder / "triangle.obj").string(),
                                    "--size", "32x32", "-o", "-"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with(pngSignature));
}

/// Renders that must fail: arguments after "render", and a word of the message.
struct Failure {
    std::vector<std::string> arguments;
    std::string word;
};

class RenderFailure : public testing::TestWithParam<Failure> {};

TEST_P(RenderFailure, Message_SaysWhatWasWrong) {
    std::vector<std::string> arguments = {"render"};
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    EXPECT_NE(patina(arguments).err.find(GetParam().word), std::string::npos)
        << patina(arguments).err;
}

TEST_P(RenderFailure, Exit_IsOneAndStandardOutputStaysEmpty) {
    std::vector<std::string> arguments = {"render"};
    arguments.insert(arguments.end(), GetParam().arguments.begin(), GetParam().arguments.end());
    const Outcome outcome = patina(arguments);
    EXPECT_EQ(std::pair(outcome.exitCode, outcome.out), std::pair(1, std::string()));
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, RenderFailure,
    testing::Values(Failure{{"missing.patina.json", "-o", "-"}, "missing.patina.json"},
                    Failure{{gold, "-o", "/nowhere/at/all.png"}, "/nowhere/at"},
                    Failure{{gold, "-o", "picture.unknown"}, "picture.unknown"},
                    Failure{{"--model", "no-such-model", "-o", "-"}, "no-such-model"},
                    Failure{{gold, "--set", "no.such=1", "-o", "-"}, "no.such"},
                    Failure{{gold, "--set", "roughness=nan", "-o", "-"}, "roughness"},
                    Failure{{gold, "--set", "roughness=1e999", "-o", "-"}, "roughness"},
                    Failure{{gold, "--set", "distribution=wide", "-o", "-"}, "wide"},
                    Failure{{gold, "--set", "=3", "-o", "-"}, "id=value"},
                    Failure{{gold, "--exposure", "nan", "-o", "-"}, "exposure"},
                    Failure{{gold, "--exposure", "1e999", "-o", "-"}, "exposure"},
                    Failure{{gold, "--size", "8x8", "--size", "9x9", "-o", "-"},
                            "--size: given 2 times; expected once"},
                    Failure{{gold, "--exposure", "33", "-o", "-"}, "32"},
                    Failure{{gold, "--size", "20000x20000", "-o", "-"}, "20000"},
                    Failure{{gold, "--size", "0x10", "-o", "-"}, "size"},
                    Failure{{gold, "--size", "banana", "-o", "-"}, "size"},
                    Failure{{"--model", "phong", "--specular", "gaussian", "-o", "-"}, "no place"},
                    Failure{{gold, "--show", "smell", "-o", "-"}, "numbers, energy, normals"},
                    Failure{{gold, "--show", "light=moon", "-o", "-"}, "no light \"moon\""},
                    Failure{{gold, "--mesh", "builtin:teapot", "-o", "-"}, "teapot"},
                    Failure{{gold, "--mesh", "missing.obj", "-o", "-"}, "missing.obj"},
                    Failure{{gold, "--scene", "missing.patina-scene.json", "-o", "-"},
                            "missing.patina-scene"}));

TEST(RenderCommand, OldOpenGl_SaysWhatWasFoundAndExitsWithOne) {
    const Outcome outcome = patina(Start{.arguments = {"render", gold, "-o", "-"},
                                         .environment = {{"MESA_GL_VERSION_OVERRIDE", "3.3"}},
                                         .input = {}});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("4.1"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("3.3"), std::string::npos) << outcome.err;
}

} // namespace
} // namespace patina::tests::render_test
