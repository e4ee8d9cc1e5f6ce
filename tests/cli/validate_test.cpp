// SPDX-License-Identifier: GPL-3.0-or-later
#include <regex>

#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::validate_test {
namespace {

/// A sound preset.
const std::string soundPreset = R"({
  "format": "patina.preset",
  "fresnel": {"id": "schlick", "parameters": {"f0": [0.9, 0.8, 0.3]}, "version": 1},
  "model": {"id": "cook-torrance", "version": 1},
  "name": "Gold",
  "opacity": 1.0,
  "parameters": {"distribution": "ggx", "roughness": 0.25, "specular.color": [1, 1, 1]},
  "version": 1
}
)";

std::vector<std::string> filesBelow(const std::string& folder, const std::string& ending) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shipped(folder))) {
        if (entry.path().string().ends_with(ending)) {
            files.push_back(entry.path().string());
        }
    }
    return files;
}

Outcome validate(std::vector<std::string> files) {
    files.insert(files.begin(), "validate");
    return patina(files);
}

TEST(ValidateCommand, ShippedPresetsAndScenes_AreValid) {
    const Outcome outcome = validate(filesBelow("presets", ".patina.json"));
    const Outcome scenes = validate(filesBelow("presets", ".patina-scene.json"));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(scenes.exitCode, 0) << scenes.err;
    EXPECT_EQ(scenes.err, "");
}

TEST(ValidateCommand, ShippedDescriptors_AreValid) {
    const Outcome outcome = validate(filesBelow("shaders", ".json"));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
}

TEST(ValidateCommand, SoundPresetOfTheseTests_IsValid) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina.json", soundPreset);
    const Outcome outcome = validate({(folder / "a.patina.json").string()});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
}

TEST(ValidateCommand, SheetWithoutItsPreset_IsToldWithThePlace) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina-sheet.json", R"({"format": "patina.sheet", "version": 1,
"preset": "gone.patina.json", "x": {"models": []}})");
    const Outcome outcome = validate({(folder / "a.patina-sheet.json").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find(":2:11: there is no preset"), std::string::npos) << outcome.err;
}

TEST(ValidateCommand, OneBadFileOfTwo_ExitsWithOne) {
    const TemporaryFolder folder;
    writeFile(folder / "bad.patina.json", "{}");
    const std::string good = shipped("presets/strauss/brass.patina.json").string();
    EXPECT_EQ(validate({good, (folder / "bad.patina.json").string()}).exitCode, 1);
}

TEST(ValidateCommand, FileThatLeavesItsFolder_IsRefused) {
    const TemporaryFolder folder;
    std::string text = readFile(shipped("presets/strauss/brass.patina.json"));
    text.replace(text.find("\"textures\": {}"), 14,
                 "\"textures\": {\"diffuse.color\": {\"file\": \"../../secret.png\"}}");
    writeFile(folder / "a.patina.json", text);
    const Outcome outcome = validate({(folder / "a.patina.json").string()});
    EXPECT_NE(outcome.err.find("../../secret.png"), std::string::npos) << outcome.err;
}

TEST(ValidateCommand, SlotWithAnUnknownDefault_IsNotValid) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder / "models");
    writeFile(folder / "models/mine.glsl", "");
    writeFile(folder / "models/mine.json", R"({"id": "mine", "version": 1, "label": "Mine",
"parameters": [], "slots": [{"kind": "fresnel", "default": "schlik"}]})");
    const Outcome outcome = validate({(folder / "models/mine.json").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("mine.json:2:60: there is no fresnel block \"schlik\"; expected "
                               "'schlick'"),
              std::string::npos)
        << outcome.err;
}

/// Writes a model of a folder with a Fresnel term beside it.
std::string modelWithASlot(const TemporaryFolder& folder, const std::string& value) {
    std::filesystem::create_directories(folder / "models");
    std::filesystem::create_directories(folder / "fresnel");
    writeFile(folder / "fresnel/ours.json",
              R"({"id": "ours", "version": 1, "label": "Ours", "parameters": []})");
    writeFile(folder / "fresnel/ours.glsl",
              "#include \"lib/fresnel.glsl\"\n"
              "vec3 oursFresnel(Incidence i, OursFresnel p) { return vec3(i.versine); }\n"
              "vec3 oursFresnelTint(OursFresnel p) { return vec3(1.0); }\n");
    writeFile(folder / "models/mine.json", R"({"id": "mine", "version": 1, "label": "Mine",
"parameters": [], "slots": [{"kind": "fresnel", "default": "ours"}]})");
    writeFile(folder / "models/mine.glsl", "#include \"lib/directions.glsl\"\n"
                                           "vec3 mine(Directions d, Mine p) {\n    return " +
                                               value + ";\n}\n");
    return (folder / "models/mine.json").string();
}

TEST(ValidateCommand, SlotWithABlockBesideTheFile_IsValid) {
    const TemporaryFolder folder;
    const Outcome outcome = validate({modelWithASlot(folder, "vec3(d.nl)")});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
}

TEST(ValidateCommand, MistakeInABlocksShader_IsToldWithItsLine) {
    const TemporaryFolder folder;
    const Outcome outcome = validate({modelWithASlot(folder, "vec3(d.nm)")});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("mine.glsl:3:"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("nm"), std::string::npos) << outcome.err;
}

std::string replacedAll(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); !from.empty() && at != std::string::npos;
         at = text.find(from, at)) {
        text.replace(at, from.size(), to);
        at += to.size();
    }
    return text;
}

/// Validates a copy of a shipped block under the name "mine", with something of its GLSL replaced.
/// `word` ends the names of the kind's functions.
Outcome validateDamagedCopy(const std::string& file, const std::string& word,
                            const std::string& from, const std::string& to) {
    const TemporaryFolder folder;
    const std::string kind = file.substr(0, file.find('/'));
    const std::string id = file.substr(kind.size() + 1);
    std::string capital = id;
    capital.front() = static_cast<char>(capital.front() - 'a' + 'A');
    std::string shader = readFile(shipped("shaders/" + file + ".glsl"));
    shader =
        replacedAll(replacedAll(shader, id + word, "mine" + word), capital + word, "Mine" + word);
    const std::string descriptor = readFile(shipped("shaders/" + file + ".json"));
    std::filesystem::create_directories(folder / kind);
    writeFile(folder / (kind + "/mine.glsl"), replacedAll(shader, from, to));
    writeFile(folder / (kind + "/mine.json"),
              replacedAll(descriptor, "\"id\": \"" + id + "\"", "\"id\": \"mine\""));
    return validate({(folder / (kind + "/mine.json")).string()});
}

/// Only the vertex stage asks how large a mark is, and where a layer of strands lies.
TEST(ValidateCommand, MistakeInTheVertexStageOfABlock_IsToldWithItsLine) {
    EXPECT_EQ(validateDamagedCopy("strokes/stipple", "Strokes", "", "").err, "");
    const Outcome strokes =
        validateDamagedCopy("strokes/stipple", "Strokes", "vec2(p.dotLength", "vec2(p.dotLangth");
    EXPECT_EQ(strokes.exitCode, 1);
    EXPECT_NE(strokes.err.find("mine.glsl:15:"), std::string::npos) << strokes.err;
    const Outcome shells = validateDamagedCopy("shells/fur", "Shells", "s.height * (up * s.n",
                                               "s.height * (up * s.normal");
    EXPECT_EQ(shells.exitCode, 1);
    EXPECT_NE(shells.err.find("mine.glsl:28:"), std::string::npos) << shells.err;
}

TEST(ValidateCommand, BlockWithoutAShader_IsNotValid) {
    const TemporaryFolder folder;
    const std::string model = modelWithASlot(folder, "vec3(d.nl)");
    std::filesystem::remove(folder / "models/mine.glsl");
    EXPECT_EQ(validate({model}).exitCode, 1);
}

/// A scene whose only object has that mesh.
Outcome validateSceneWith(const std::string& mesh) {
    const TemporaryFolder folder;
    writeFile(folder / "there.obj", "");
    writeFile(folder / "a.patina-scene.json",
              "{\"format\": \"patina.scene\", \"version\": 1, \"objects\": [\n{\"mesh\": \"" +
                  mesh + "\", \"preset\": " + soundPreset + "}]}");
    return validate({(folder / "a.patina-scene.json").string()});
}

TEST(ValidateCommand, SceneWithAMissingMesh_IsNotValid) {
    const Outcome outcome = validateSceneWith("gone.obj");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("a.patina-scene.json:2:10: there is no file"), std::string::npos)
        << outcome.err;
}

TEST(ValidateCommand, PresetWithAMissingImage_IsNotValid) {
    const TemporaryFolder folder;
    std::string text = soundPreset;
    text.insert(1, "\"textures\": {\n\"diffuse.color\": {\"file\": \"gone.png\"}},");
    writeFile(folder / "a.patina.json", text);
    const Outcome outcome = validate({(folder / "a.patina.json").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("there is no image"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("a.patina.json:2:27: "), std::string::npos) << outcome.err;
    writeFile(folder / "gone.png", "");
    EXPECT_EQ(validate({(folder / "a.patina.json").string()}).exitCode, 0);
}

/// What each part of a scene names is looked for, in the scene's folder.
TEST(ValidateCommand, SceneWithMissingPictures_IsNotValid) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina-scene.json", R"({"format": "patina.scene", "version": 1,
"passes": [{"id": "screen", "version": 1, "parameters": {
"mark": "image", "threshold": "dots.png"}}],
"environment": {"id": "image", "version": 1, "parameters": {
"image": "sky.hdr"}}})");
    const std::string scene = (folder / "a.patina-scene.json").string();
    const Outcome outcome = validate({scene});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find(":3:31: there is no picture"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("dots.png"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(":5:10: there is no picture"), std::string::npos) << outcome.err;
    writeFile(folder / "dots.png", "");
    writeFile(folder / "sky.hdr", "");
    EXPECT_EQ(validate({scene}).err, "");
}

TEST(ValidateCommand, SceneWithAnUnknownBuiltinMesh_IsNotValid) {
    const Outcome outcome = validateSceneWith("builtin:spher");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("expected 'sphere'"), std::string::npos) << outcome.err;
}

TEST(ValidateCommand, UnknownBuiltinMesh_IsToldOnce) {
    const std::string said = validateSceneWith("builtin:spher").err;
    EXPECT_EQ(said.find("spher\""), said.rfind("spher\"")) << said;
}

TEST(ValidateCommand, SceneWhoseMeshIsThere_IsValid) {
    for (const char* mesh : {"there.obj", "builtin:sphere"}) {
        const Outcome outcome = validateSceneWith(mesh);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    }
}

/// One piece of its text replaced by another.
struct Damage {
    std::string name;
    std::string from;
    std::string to;
};

class DamagedPreset : public testing::TestWithParam<Damage> {
  protected:
    Outcome validated() {
        const TemporaryFolder folder;
        std::string text = soundPreset;
        const auto at = text.find(GetParam().from);
        EXPECT_NE(at, std::string::npos) << GetParam().from;
        text.replace(at, GetParam().from.size(), GetParam().to);
        writeFile(folder / "a.patina.json", text);
        return validate({(folder / "a.patina.json").string()});
    }
};

TEST_P(DamagedPreset, Exit_IsOne) {
    EXPECT_EQ(validated().exitCode, 1);
}

TEST_P(DamagedPreset, Message_HasFileLineAndColumn) {
    static const std::regex place("a\\.patina\\.json:[0-9]+:[0-9]+: ");
    const std::string err = validated().err;
    EXPECT_TRUE(std::regex_search(err, place)) << err;
}

INSTANTIATE_TEST_SUITE_P(
    BadInput, DamagedPreset,
    testing::Values(Damage{"truncated", "\"name\"", "\"na"},
                    Damage{"nan", "\"roughness\": 0.25", "\"roughness\": NaN"},
                    Damage{"huge", "\"roughness\": 0.25", "\"roughness\": 1e999"},
                    Damage{"text", "\"roughness\": 0.25", "\"roughness\": \"rough\""},
                    Damage{"number", "\"specular.color\": [1, 1, 1]", "\"specular.color\": -1"},
                    Damage{"enum", "\"ggx\"", "\"wide\""},
                    Damage{"newer", "\"version\": 1\n}", "\"version\": 99\n}"},
                    Damage{"format", "\"patina.preset\"", "\"other\""},
                    Damage{"repeated", "\"opacity\": 1.0", "\"opacity\": 1.0, \"opacity\": 1.0"},
                    Damage{"binary", "\"name\"", std::string("\0\1\2", 3)}),
    [](const testing::TestParamInfo<Damage>& damage) { return damage.param.name; });

TEST(ValidateCommand, MisspeltAccuracyChoice_IsAMistakeWithTheKnownOnes) {
    const TemporaryFolder folder;
    std::string preset = soundPreset;
    preset.insert(preset.find("  \"fresnel\""), "  \"accuracy\": {\"shadowin\": \"schlick\"},\n");
    writeFile(folder / "a.patina.json", preset);
    writeFile(folder / "a.patina-scene.json", R"({"format": "patina.scene", "version": 1,
  "accuracy": {"scal": "half"}})");
    const Outcome ofPreset = validate({(folder / "a.patina.json").string()});
    EXPECT_EQ(ofPreset.exitCode, 1);
    EXPECT_NE(ofPreset.err.find("a.patina.json:3:28: \"shadowin\" is no accuracy choice; expected "
                                "'shadowing', or one of facets, shadowing"),
              std::string::npos)
        << ofPreset.err;
    const Outcome ofScene = validate({(folder / "a.patina-scene.json").string()});
    EXPECT_EQ(ofScene.exitCode, 1);
    EXPECT_NE(ofScene.err.find("a.patina-scene.json:2:24: \"scal\" is no accuracy choice of the "
                               "picture; expected 'scale', or one of samples"),
              std::string::npos)
        << ofScene.err;
}

// A part of a scene is drawn by its exact way, whatever levels its block has.
TEST(ValidateCommand, LevelsInAPart_AreAMistakeAtTheirPlace) {
    const TemporaryFolder folder;
    const std::string scene = (folder / "a.patina-scene.json").string();
    writeFile(scene, R"({"format": "patina.scene", "version": 1,
  "fog": {"id": "height",
    "accuracy": {"cheaper.height": "found-1"}},
  "lights": [{"id": "point", "accuracy": {}}]})");
    const Outcome ofScene = validate({scene});
    EXPECT_EQ(ofScene.exitCode, 1);
    EXPECT_NE(ofScene.err.find("a.patina-scene.json:3:17: no level of a fog is chosen: its exact "
                               "way is drawn; expected no \"accuracy\" here"),
              std::string::npos)
        << ofScene.err;
    EXPECT_NE(ofScene.err.find("a.patina-scene.json:4:42: no level of a light"), std::string::npos)
        << ofScene.err;
    std::string preset = soundPreset;
    preset.replace(preset.find("\"model\": {"), 10, "\"model\": {\"accuracy\": {}, ");
    writeFile(folder / "a.patina.json", preset);
    const Outcome ofPreset = validate({(folder / "a.patina.json").string()});
    EXPECT_EQ(ofPreset.exitCode, 1);
    EXPECT_NE(ofPreset.err.find("\"accuracy\" of the preset itself"), std::string::npos)
        << ofPreset.err;
}

/// What a model kept of another one's is no slip.
TEST(ValidateCommand, AccuracyChoiceOfAnotherModel_IsValid) {
    const TemporaryFolder folder;
    std::string preset = soundPreset;
    preset.insert(preset.find("  \"fresnel\""), "  \"accuracy\": {\"matte\": \"fujii\"},\n");
    writeFile(folder / "a.patina.json", preset);
    EXPECT_EQ(validate({(folder / "a.patina.json").string()}).err, "");
}

TEST(ValidateCommand, DeeplyNestedFile_IsRefusedQuickly) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina.json", std::string(1'000'000, '['));
    const Outcome outcome = validate({(folder / "a.patina.json").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_LT(outcome.seconds, 5.0);
}

TEST(ValidateCommand, HugeFile_IsRefusedQuickly) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina.json", std::string(100'000'000, ' '));
    const Outcome outcome = validate({(folder / "a.patina.json").string()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_LT(outcome.seconds, 5.0);
}

TEST(ValidateCommand, EmptyFile_IsRefused) {
    const TemporaryFolder folder;
    writeFile(folder / "a.patina.json", "");
    EXPECT_EQ(validate({(folder / "a.patina.json").string()}).exitCode, 1);
}

} // namespace
} // namespace patina::tests::validate_test
