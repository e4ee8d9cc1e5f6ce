// SPDX-License-Identifier: GPL-3.0-or-later
// Images on surfaces from the command line.
#include <gtest/gtest.h>

#include "cli/patina_program.h"

namespace patina::tests::texture_test {
namespace {

class TextureOption : public testing::Test {
  protected:
    TextureOption() {
        // Any picture will do as an image: one that was drawn before.
        const Outcome outcome = patina(
            {"render", "--model", "lambert", "--size", "16x16", "-o", folder_ / "image.png"});
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    }

    Outcome drawn(std::vector<std::string> more, const std::string& name = "out.png") {
        std::vector<std::string> all{"render", "--model", "phong",       "--size",
                                     "16x16",  "-o",      folder_ / name};
        all.insert(all.end(), more.begin(), more.end());
        return patina(all);
    }

    std::string image() const { return folder_ / "image.png"; }

    TemporaryFolder folder_;
};

TEST_F(TextureOption, ImageOnAColor_ChangesThePicture) {
    ASSERT_EQ(drawn({}, "plain.png").exitCode, 0);
    const Outcome outcome = drawn({"--texture", "diffuse.color=" + image()});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(readFile(folder_ / "out.png"), readFile(folder_ / "plain.png"));
}

TEST_F(TextureOption, Setting_ChangesHowItLies) {
    ASSERT_EQ(drawn({"--texture", "diffuse.color=" + image()}, "plain.png").exitCode, 0);
    const Outcome outcome =
        drawn({"--texture", "diffuse.color=" + image(), "--texture", "diffuse.color:scale=3,3"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(readFile(folder_ / "out.png"), readFile(folder_ / "plain.png"));
}

/// Pictures that were drawn have no transparent part: their grey counts.
TEST_F(TextureOption, PictureWithoutAlphaOnTheOpacity_MakesHoles) {
    ASSERT_EQ(drawn({}, "plain.png").exitCode, 0);
    ASSERT_EQ(drawn({}, "mask.exr").exitCode, 0);
    for (const std::string& mask : {image(), std::string(folder_ / "mask.exr")}) {
        const Outcome outcome =
            drawn({"--texture", "opacity=" + mask, "--texture", "opacity:cutOut=true"});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(readFile(folder_ / "out.png"), readFile(folder_ / "plain.png")) << mask;
    }
}

TEST_F(TextureOption, SetInTheWordsOfFiles_IsTheSamePicture) {
    const Outcome usual = drawn({"--texture", "diffuse.color=" + image(), "--texture",
                                 "diffuse.color:scale=3,3", "--texture", "normal=" + image()});
    ASSERT_EQ(usual.exitCode, 0) << usual.err;
    const std::string picture = readFile(folder_ / "out.png");
    using Words = std::pair<const char*, const char*>;
    for (const auto& [color, normal] : {Words{"textures.diffuse.color.file=", "normal="},
                                        Words{"diffuse.color=", "textures.normal="}}) {
        const Outcome outcome =
            drawn({"--set", color + image(), "--set", "textures.diffuse.color.scale=3,3", "--set",
                   normal + image()});
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(readFile(folder_ / "out.png"), picture) << color;
    }
}

TEST_F(TextureOption, SetOnAPass_IsItsImage) {
    const std::vector<std::string> pass{"--pass", "screen", "--set", "pass.mark=image"};
    ASSERT_EQ(drawn(pass, "even.png").exitCode, 0);
    std::vector<std::string> more = pass;
    more.insert(more.end(), {"--set", "pass.threshold=" + image()});
    const Outcome outcome = drawn(more);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(readFile(folder_ / "out.png"), readFile(folder_ / "even.png"));
    more.back() = "pass.threshold=/nowhere/a.png";
    const Outcome missing = drawn(more);
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_NE(missing.err.find("/nowhere/a.png: --set pass.threshold=/nowhere/a.png: no such file"),
              std::string::npos)
        << missing.err;
}

TEST_F(TextureOption, UnknownSetting_SaysWhichThereAre) {
    const Outcome outcome =
        drawn({"--texture", "diffuse.color=" + image(), "--texture", "diffuse.color:warp=1"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("one of channel, colorSpace, mode"), std::string::npos)
        << outcome.err;
}

TEST_F(TextureOption, ValueThatTakesNone_IsAnError) {
    const Outcome outcome = drawn({"--texture", "normalisation=" + image()});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("The value takes no image."), std::string::npos) << outcome.err;
}

TEST_F(TextureOption, MissingFile_IsAnError) {
    const Outcome outcome = drawn({"--texture", "diffuse.color=/nowhere/a.png"});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find("/nowhere/a.png: no such file"), std::string::npos) << outcome.err;
}

TEST_F(TextureOption, WhatIsNoOrdinaryFile_IsToldSo) {
    const std::string expected =
        "; expected an image, or builtin:vertex-colors for the mesh's own\n";
    const Outcome device = drawn({"--texture", "diffuse.color=/dev/zero"});
    EXPECT_EQ(device.exitCode, 1);
    EXPECT_EQ(device.err, "/dev/zero: is a device" + expected);
    const Outcome folder = drawn({"--texture", "diffuse.color=" + folder_.path().string()});
    EXPECT_EQ(folder.err, folder_.path().string() + ": is a folder" + expected);
}

TEST_F(TextureOption, FileCutShort_IsAnErrorWithoutAPicture) {
    const std::string whole = readFile(image());
    writeFile(folder_ / "half.png", whole.substr(0, whole.size() / 2));
    const std::string half = folder_ / "half.png";
    const Outcome outcome = drawn({"--texture", "diffuse.color=" + half});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find(half + ": "), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.png"));
}

TEST_F(TextureOption, EmptyFile_IsAnError) {
    writeFile(folder_ / "empty.png", "");
    const std::string empty = folder_ / "empty.png";
    const Outcome outcome = drawn({"--texture", "normal=" + empty});
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.err.find(empty + ": "), std::string::npos) << outcome.err;
}

TEST_F(TextureOption, MissingFileInAPreset_IsAMessageAndAPicture) {
    writeFile(folder_ / "a.patina.json",
              R"({"format": "patina.preset", "version": 1, "model": {"id": "lambert"},)"
              R"( "textures": {"diffuse.color": {"file": "gone.png"}}})");
    const Outcome outcome =
        patina({"render", folder_ / "a.patina.json", "--size", "16x16", "-o", folder_ / "out.png"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("gone.png: no such file"), std::string::npos) << outcome.err;
    const Outcome effects = patina({"effects", "--no-cost", folder_ / "a.patina.json"});
    EXPECT_NE(effects.out.find("missing or cannot be read: a placeholder"), std::string::npos)
        << effects.out;
    EXPECT_NE(effects.err.find("gone.png: no such file"), std::string::npos) << effects.err;
}

TEST_F(TextureOption, MeshWithoutTextureCoordinates_IsSaid) {
    writeFile(folder_ / "bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string mesh = folder_ / "bare.obj";
    EXPECT_EQ(drawn({"--mesh", mesh}).err, "");
    const Outcome picture = drawn({"--mesh", mesh, "--texture", "diffuse.color=" + image()});
    EXPECT_EQ(picture.exitCode, 0);
    EXPECT_NE(picture.err.find(mesh + ": the mesh has no texture coordinates"), std::string::npos)
        << picture.err;
    const Outcome effects = patina({"effects", "--no-cost", "--model", "phong", "--mesh", mesh,
                                    "--texture", "diffuse.color=" + image()});
    EXPECT_NE(effects.out.find("The mesh has no texture coordinates: it is one colour."),
              std::string::npos)
        << effects.out;
}

TEST_F(TextureOption, MeshWithTextureCoordinates_IsNot) {
    writeFile(folder_ / "laid.obj",
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    const std::string mesh = folder_ / "laid.obj";
    EXPECT_EQ(drawn({"--mesh", mesh, "--texture", "diffuse.color=" + image()}).err, "");
}

/// Red, green and blue corners on a mesh that fills the view.
class VertexColorOption : public TextureOption {
  protected:
    VertexColorOption() {
        writeFile(folder_ / "painted.obj", "v -1 -1 0 1 0 0\nv 1 -1 0 0 1 0\nv 0 1 0 0 0 1\n"
                                           "f 1 2 3\n");
    }

    std::string mesh() const { return folder_ / "painted.obj"; }
};

TEST_F(VertexColorOption, ByEitherOption_ColourThePictureAlike) {
    ASSERT_EQ(drawn({"--mesh", mesh()}, "plain.png").exitCode, 0);
    const Outcome byTexture =
        drawn({"--mesh", mesh(), "--texture", "diffuse.color=builtin:vertex-colors"});
    EXPECT_EQ(byTexture.exitCode, 0);
    EXPECT_EQ(byTexture.err, "");
    EXPECT_NE(readFile(folder_ / "out.png"), readFile(folder_ / "plain.png"));
    for (const char* set : {"diffuse.color=builtin:vertex-colors",
                            "textures.diffuse.color.file=builtin:vertex-colors"}) {
        ASSERT_EQ(drawn({"--mesh", mesh(), "--set", set}, "set.png").exitCode, 0) << set;
        EXPECT_EQ(readFile(folder_ / "set.png"), readFile(folder_ / "out.png")) << set;
    }
}

TEST_F(VertexColorOption, InAPreset_AreReadAndChecked) {
    writeFile(
        folder_ / "painted.patina.json",
        R"({"format": "patina.preset", "version": 1, "model": {"id": "lambert", "version": 1},)"
        R"( "textures": {"diffuse.color": {"file": "builtin:vertex-colors"}}})");
    const std::string preset = folder_ / "painted.patina.json";
    const Outcome checked = patina({"validate", preset});
    EXPECT_EQ(checked.exitCode, 0) << checked.err;
    const Outcome outcome = patina(
        {"render", preset, "--mesh", mesh(), "--size", "16x16", "-o", folder_ / "preset.png"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST_F(VertexColorOption, MeshWithout_IsSaid) {
    const Outcome outcome = drawn({"--texture", "diffuse.color=builtin:vertex-colors"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("the mesh has no vertex colours: they count as white"),
              std::string::npos)
        << outcome.err;
}

TEST_F(VertexColorOption, SwitchedOff_AreNotMissed) {
    writeFile(
        folder_ / "unpainted.patina.json",
        R"({"format": "patina.preset", "version": 1, "model": {"id": "lambert", "version": 1},)"
        R"( "textures": {"diffuse.color": {"file": "builtin:vertex-colors", "enabled": false}}})");
    const Outcome outcome = patina({"render", folder_ / "unpainted.patina.json", "--size", "16x16",
                                    "-o", folder_ / "preset.png"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST_F(VertexColorOption, Effects_NameThem) {
    const Outcome outcome = patina({"effects", "--no-cost", "--model", "phong", "--mesh", mesh(),
                                    "--texture", "diffuse.color=builtin:vertex-colors"});
    EXPECT_NE(outcome.out.find("(vertex colours: colour, in place of the value)"),
              std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("The mesh's vertex colours drive it."), std::string::npos)
        << outcome.out;
}

TEST_F(TextureOption, Effects_NameTheImage) {
    const Outcome outcome = patina(
        {"effects", "--no-cost", "--model", "phong", "--texture", "diffuse.color=" + image()});
    EXPECT_NE(outcome.out.find("texture/diffuse.color"), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("(colour, in place of the value)"), std::string::npos)
        << outcome.out;
}

} // namespace
} // namespace patina::tests::texture_test
