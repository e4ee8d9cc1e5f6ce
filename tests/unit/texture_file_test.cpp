// SPDX-License-Identifier: GPL-3.0-or-later
// Images in preset and scene files.
#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "material/preset_file.h"
#include "schema_check.h"
#include "support/program.h"

namespace patina::texture_file_test {
namespace {

using json = nlohmann::json;

Checked<PresetReading> reading(const json& textures, const std::string& file = "/looks/a.json") {
    const json preset{{"format", "patina.preset"},
                      {"version", 1},
                      {"model", {{"id", "not-here"}}},
                      {"textures", textures}};
    return materialFromJson(*parseJson(writeJson(preset), file), "", Catalog());
}

/// One image under "diffuse.color", read.
TextureUse use(const json& texture) {
    const auto read = reading({{"diffuse.color", texture}});
    EXPECT_TRUE(read) << (read ? "" : text(read.error()));
    return read ? read->material.textures.at("diffuse.color") : TextureUse();
}

json fullTexture() {
    return {{"file", "maps/wood.png"}, {"colorSpace", "linear"}, {"channel", "g"},
            {"mode", "multiply"},      {"wrap", "mirror"},       {"filter", "nearest"},
            {"scale", {2.0, 0.5}},     {"offset", {0.25, -1.0}}, {"rotation", 30.0},
            {"strength", 0.75}};
}

TEST(TextureFile, EverySetting_IsRead) {
    TextureUse expected = textureUse("diffuse.color", "/looks/maps/wood.png");
    expected.colorSpace = TextureColorSpace::Linear;
    expected.channel = TextureChannel::Green;
    expected.mode = TextureMode::Multiply;
    expected.wrap = TextureWrap::Mirror;
    expected.filter = TextureFilter::Nearest;
    expected.scale = {2.0, 0.5};
    expected.offset = {0.25, -1.0};
    expected.rotation = 30.0;
    expected.strength = 0.75;
    EXPECT_EQ(use(fullTexture()), expected);
}

TEST(TextureFile, EverySetting_IsWrittenAsItWasRead) {
    const auto read = reading({{"diffuse.color", fullTexture()}});
    EXPECT_EQ(toJson(read->material, "/looks")["textures"]["diffuse.color"], fullTexture());
}

TEST(TextureFile, SwitchedOff_IsReadAndWritten) {
    json off = fullTexture();
    off["enabled"] = false;
    EXPECT_FALSE(use(off).enabled);
    const auto read = reading({{"diffuse.color", off}});
    EXPECT_EQ(toJson(read->material, "/looks")["textures"]["diffuse.color"], off);
    EXPECT_TRUE(use(fullTexture()).enabled);
}

/// They are no file: nothing is looked for, and nothing is asked for outside the folder.
TEST(TextureFile, VertexColours_AreReadAndWrittenByTheirName) {
    const json colors{{"file", vertexColorsName}, {"mode", "multiply"}, {"channel", "g"}};
    EXPECT_EQ(use(colors).file, vertexColorsName);
    EXPECT_FALSE(use(colors).outside);
    const auto read = reading({{"diffuse.color", colors}});
    EXPECT_TRUE(read->outside.empty());
    const json written = toJson(read->material, "/looks")["textures"]["diffuse.color"];
    EXPECT_EQ(written["file"], vertexColorsName);
    EXPECT_EQ(written["channel"], "g");
}

/// The image of a preset in a folder, where it is a link to `target`.
TextureUse linked(const std::filesystem::path& target) {
    const tests::TemporaryFolder folder;
    std::filesystem::create_directories(folder / "looks/maps");
    tests::writeFile(folder / "secret.png", "");
    tests::writeFile(folder / "looks/maps/wood.png", "");
    std::filesystem::create_symlink(target, folder / "looks/a.png");
    const auto read =
        reading({{"diffuse.color", {{"file", "a.png"}}}}, (folder / "looks/a.json").string());
    return read->material.textures.at("diffuse.color");
}

TEST(TextureFile, LinkOutOfTheFolder_IsOutside) {
    EXPECT_TRUE(linked("../secret.png").outside);
}

TEST(TextureFile, LinkWithinTheFolder_IsUsed) {
    EXPECT_FALSE(linked("maps/wood.png").outside);
}

TEST(TextureFile, UnknownKeysAndChoices_AreWrittenBack) {
    json odd = fullTexture();
    odd["wrap"] = "spiral";
    odd["x-odd"] = {1, 2};
    const auto read = reading({{"diffuse.color", odd}});
    ASSERT_TRUE(read) << text(read.error());
    EXPECT_EQ(toJson(read->material, "/looks")["textures"]["diffuse.color"], odd);
}

TEST(TextureFile, UnknownChoice_IsNotedWithItsPlace) {
    json odd = fullTexture();
    odd["wrap"] = "spiral";
    const auto read = reading({{"diffuse.color", odd}});
    EXPECT_EQ(read->material.textures.at("diffuse.color").wrap, TextureWrap::Repeat);
    const auto note = std::ranges::find_if(read->notes, [](const Error& each) {
        return each.problem.find("spiral") != std::string::npos;
    });
    ASSERT_NE(note, read->notes.end());
    EXPECT_GT(note->line, 1);
    EXPECT_NE(note->expected.find("mirror"), std::string::npos);
}

TEST(TextureFile, WrongType_IsAnErrorWithItsPlace) {
    json wrong = fullTexture();
    wrong["scale"] = "big";
    const auto read = reading({{"diffuse.color", wrong}});
    ASSERT_FALSE(read);
    EXPECT_GT(read.error().front().line, 1);
}

TEST(TextureFile, StrengthOutsideItsRange_IsBroughtInWithANote) {
    const auto read = reading({{"diffuse.color", {{"file", "a.png"}, {"strength", 5}}}});
    EXPECT_EQ(read->material.textures.at("diffuse.color").strength, 1.0);
    EXPECT_NE(text(read->notes).find("outside its range"), std::string::npos);
}

TEST(TextureFile, FileOutsideTheFolder_IsMarkedAndKept) {
    const auto read = reading({{"normal", {{"file", "../secret.png"}}}});
    EXPECT_TRUE(read->material.textures.at("normal").outside);
    EXPECT_EQ(toJson(read->material, "/looks")["textures"]["normal"]["file"], "../secret.png");
}

TEST(TextureFile, FileInTheFolder_IsTrusted) {
    EXPECT_FALSE(use({{"file", "maps/wood.png"}}).outside);
}

TEST(TextureFile, PresetSavedElsewhere_NamesTheSameFile) {
    const auto read = reading({{"diffuse.color", {{"file", "wood.png"}}}});
    EXPECT_EQ(toJson(read->material, "/other")["textures"]["diffuse.color"]["file"],
              "../looks/wood.png");
}

TEST(TextureFile, OpacityAlone_CanBeCutOut) {
    const json cut{{"file", "a.png"}, {"cutOut", true}, {"threshold", 0.25}};
    const auto read = reading({{"opacity", cut}, {"diffuse.color", cut}});
    EXPECT_TRUE(read->material.textures.at("opacity").cutOut);
    EXPECT_EQ(read->material.textures.at("opacity").threshold, 0.25);
    EXPECT_FALSE(read->material.textures.at("diffuse.color").cutOut);
}

TEST(TextureFile, Written_FollowsTheSchema) {
    const auto read = reading({{"diffuse.color", fullTexture()},
                               {"opacity", {{"file", "a.png"}}},
                               {"normal", {{"file", "b.png"}}}});
    const auto document = parseJson(writeJson(toJson(read->material, "/looks")), "p");
    EXPECT_EQ(text(checkSchema(*document, "preset")), "");
}

TEST(TextureFile, WrittenFile_ReadsAsTheSameMaterial) {
    const tests::TemporaryFolder folder;
    Material before;
    before.model.id = "not-here";
    before.textures["height"] =
        textureUse("height", (std::filesystem::absolute(folder.path()) / "h.png").string());
    ASSERT_TRUE(writePreset(folder / "a.patina.json", before, Catalog()));
    EXPECT_EQ(readPreset(folder / "a.patina.json", Catalog())->material.textures, before.textures);
}

TEST(TextureSettings, EachRole_OffersWhatItUses) {
    EXPECT_EQ(textureSettings(TextureRole::Normal).parameter("mode"), nullptr);
    EXPECT_EQ(textureSettings(TextureRole::Input).parameter("cutOut"), nullptr);
    EXPECT_NE(textureSettings(TextureRole::Opacity).parameter("cutOut"), nullptr);
}

TEST(TextureSettings, Stored_IsWhatIsReadBack) {
    for (const TextureRole role :
         {TextureRole::Input, TextureRole::Normal, TextureRole::Height, TextureRole::Opacity}) {
        for (const Parameter& setting : textureSettings(role, {"rgb", "r", "a"}).parameters) {
            TextureUse changed;
            const Value other = setting.values.empty() ? conformed(setting, setting.defaultValue)
                                                       : Value(setting.values.back().id);
            storeTextureSetting(changed, setting.id, other);
            EXPECT_EQ(textureSetting(changed, setting.id), roundedToFloat(other)) << setting.id;
        }
    }
}

} // namespace
} // namespace patina::texture_file_test
