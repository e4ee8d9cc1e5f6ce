// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/preset_file.h"

#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "material/texture_path.h"
#include "schema_check.h"

namespace patina::preset_file_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

json oneParameter(const std::string& id, const std::string& type, const json& defaultValue) {
    return {{"id", id}, {"label", id}, {"type", type}, {"default", defaultValue}};
}

/// A catalogue with one model that has a parameter of each interesting type.
Catalog madePresetCatalog() {
    BlockFolder folder;
    json model = plainDescriptor("velvet");
    model["version"] = 2;
    json color = oneParameter("color", "color", {0.5, 0.5, 0.5});
    color["texture"] = {"rgb"};
    json lobe = oneParameter("lobe", "enum", "wide");
    lobe["values"] = {{{"id", "wide"}, {"label", "W"}}, {{"id", "narrow"}, {"label", "N"}}};
    json fuzz = oneParameter("fuzz", "float", 0.25);
    fuzz["migrations"] = {{{"from", "hair"}, {"until", 1}}};
    model["parameters"] = {color, lobe, fuzz, oneParameter("soft", "bool", true)};
    model["accuracy"] = {
        {{"id", "sum"},
         {"label", "Sum"},
         {"values",
          {{{"id", "full"}, {"label", "F"}, {"exact", true}}, {{"id", "fast"}, {"label", "Q"}}}}}};
    folder.add("models", model);
    folder.add("fresnel", plainDescriptor("coat"));
    return folder.load();
}

const Catalog& presetCatalog() {
    static const Catalog made = madePresetCatalog();
    return made;
}

json plainPreset() {
    return {{"format", "patina.preset"},
            {"version", 1},
            {"model", {{"id", "velvet"}, {"version", 2}}},
            {"parameters", {{"fuzz", 0.75}, {"lobe", "narrow"}}}};
}

Checked<PresetReading> readingOf(const std::string& preset) {
    const auto document = parseJson(preset, "/elsewhere/p");
    return document ? materialFromJson(*document, "", presetCatalog())
                    : Checked<PresetReading>(tl::unexpected(Errors{document.error()}));
}

Checked<PresetReading> reading(const json& changes) {
    json preset = plainPreset();
    preset.update(changes, true);
    return readingOf(writeJson(preset));
}

/// Every message, whether the preset was read or not, without its place.
std::string messages(const json& changes) {
    const auto read = reading(changes);
    std::string out;
    for (const Error& error : read ? read->notes : read.error()) {
        out += Error{{}, 0, 0, error.problem, error.expected}.text() + '\n';
    }
    return out;
}

Value valueOf(const json& changes, const std::string& id) {
    return reading(changes).value().material.model.parameters.at(id);
}

TEST(ReadPreset, Value_IsRead) {
    EXPECT_EQ(valueOf(json::object(), "fuzz"), Value(0.75));
}

TEST(ReadPreset, MissingValue_IsTheDefault) {
    EXPECT_EQ(valueOf(json::object(), "soft"), Value(true));
}

TEST(ReadPreset, PlainPreset_HasNoNotes) {
    EXPECT_EQ(messages(json::object()), "");
}

TEST(ReadPreset, Numbers_AreRoundedToFloat) {
    EXPECT_EQ(valueOf({{"parameters", {{"fuzz", 0.1}}}}, "fuzz"), Value(static_cast<double>(0.1f)));
}

TEST(ReadPreset, Message_HasFileLineAndColumn) {
    const auto read = readingOf("{\"format\": \"patina.preset\", \"version\": 1,\n"
                                " \"model\": {\"id\": \"velvet\", \"version\": 2},\n"
                                " \"parameters\": {\"color\": -1}}");
    ASSERT_FALSE(read);
    EXPECT_EQ(text(read.error()), "/elsewhere/p:3:26: the number -1 stands here; expected a "
                                  "colour: an array of 3 numbers, linear "
                                  "red, green and blue\n");
}

TEST(ReadPreset, SeveralMistakes_AreAllReported) {
    const auto read = reading({{"name", 5}, {"opacity", "x"}, {"parameters", {{"soft", 1}}}});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().size(), 3u);
}

TEST(ReadPreset, NoteBesideAMistake_IsReportedToo) {
    const auto read = reading({{"parameters", {{"soft", 1}, {"lobe", "narow"}}}});
    ASSERT_FALSE(read);
    EXPECT_NE(text(read.error()).find("\"narow\" is no choice of \"lobe\""), std::string::npos);
}

json imageOn(const std::string& key) {
    return {{"textures", {{key, {{"file", "wood.png"}}}}}};
}

TEST(ReadPreset, ImageOnAValueThatTakesOne_HasNoNotes) {
    EXPECT_EQ(messages(imageOn("color")), "");
}

TEST(ReadPreset, ImageOnAnUnknownValue_IsANote) {
    EXPECT_EQ(messages(imageOn("colour")),
              "the material has no value \"colour\" that takes an image; it is kept as it is; "
              "expected 'color', or one of opacity, normal, height, color\n");
}

TEST(ReadPreset, ImageOnAValueThatTakesNone_IsANote) {
    EXPECT_NE(messages(imageOn("fuzz")).find("no value \"fuzz\" that takes an image"),
              std::string::npos);
}

TEST(ReadPreset, ImageOnAnUnknownModelsValue_IsNotDoubted) {
    json changes = imageOn("sheen");
    changes["model"] = {{"id", "silk"}};
    EXPECT_EQ(messages(changes).find("takes an image"), std::string::npos) << messages(changes);
}

TEST(ReadPreset, OutOfRange_IsBroughtInWithANote) {
    EXPECT_EQ(valueOf({{"parameters", {{"fuzz", 7}}}}, "fuzz"), Value(1.0));
    EXPECT_EQ(messages({{"parameters", {{"fuzz", 7}}}}),
              "\"fuzz\" is outside its range and was brought into it; expected 0.0 to 1.0\n");
}

TEST(ReadPreset, NumberBeyondFloat_IsBroughtIn) {
    EXPECT_EQ(valueOf({{"parameters", {{"fuzz", 1e300}}}}, "fuzz"), Value(1.0));
}

TEST(ReadPreset, NegativeColour_IsBroughtIn) {
    EXPECT_EQ(valueOf({{"parameters", {{"color", {-1, 0.5, 0.5}}}}}, "color"),
              Value(glm::dvec3(0.0, 0.5, 0.5)));
}

TEST(ReadPreset, UnknownChoice_IsNotedWithTheChoices) {
    EXPECT_EQ(messages({{"parameters", {{"lobe", "narow"}}}}),
              "\"narow\" is no choice of \"lobe\"; the default is used; expected 'narrow', or one "
              "of wide, narrow\n");
}

TEST(ReadPreset, UnknownChoice_IsParked) {
    const Material material = reading({{"parameters", {{"lobe", "new"}}}})->material;
    EXPECT_EQ(material.model.parameters.at("lobe"), Value(std::string("wide")));
    EXPECT_EQ(material.parked["lobe"], "new");
}

TEST(ReadPreset, UnknownModel_OpensWithANote) {
    EXPECT_EQ(messages({{"model", {{"id", "velour"}}}}).substr(0, 65),
              "there is no \"velour\" among the models; its values are kept; expec");
}

TEST(ReadPreset, EmptyModel_IsAnError) {
    EXPECT_FALSE(reading({{"model", {{"id", ""}}}}));
    EXPECT_EQ(messages({{"model", {{"id", ""}}}}), "the id is empty; expected one of velvet\n");
}

TEST(ReadPreset, UnknownModel_IsWrittenAsItCame) {
    const json came{{"fuzz", 0.123456789}, {"deep", {{"x", {1, 2, 3, 4}}}}, {"n", 3}, {"t", "s"}};
    const Material material =
        reading({{"model", {{"id", "gone"}}}, {"parameters", came}})->material;
    json expected = came;
    expected["lobe"] = "narrow";
    EXPECT_EQ(toJson(material)["parameters"], expected);
}

TEST(ReadPreset, UnknownModelThatBecomesKnown_HasItsValues) {
    const Material unknown =
        materialFromJson(*parseJson(writeJson(plainPreset()), "p"), "", Catalog{})->material;
    const Material known = withModel(unknown, nullptr, *presetCatalog().find("models", "velvet"));
    EXPECT_EQ(known.model.parameters.at("fuzz"), Value(0.75));
    EXPECT_EQ(known.model.parameters.at("lobe"), Value(std::string("narrow")));
}

TEST(ReadPreset, UnknownParameter_IsNoted) {
    EXPECT_EQ(messages({{"parameters", {{"fuz", 1}}}}),
              "Label of velvet has no parameter \"fuz\"; it is kept as it is; expected 'fuzz', or "
              "one of color, lobe, fuzz, soft\n");
}

TEST(ReadPreset, ThousandUnknownParameters_GiveFewNotes) {
    json many;
    for (int i = 0; i < 1000; ++i) {
        many["p" + std::to_string(i)] = i;
    }
    EXPECT_LE(reading({{"parameters", many}})->notes.size(), 20u);
}

TEST(ReadPreset, NewerVersion_IsReadOnlyWithANote) {
    const auto read = reading({{"version", 99}});
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->readOnly);
    EXPECT_NE(text(read->notes).find("newer Patina (version 99)"), std::string::npos);
}

TEST(ReadPreset, NewerVersionThatMeansSomethingElse_StillOpens) {
    EXPECT_TRUE(reading({{"version", 99}, {"opacity", {{"front", 1}}}}));
}

TEST(ReadPreset, ThisVersion_MayBeWritten) {
    EXPECT_FALSE(reading(json::object())->readOnly);
}

TEST(ReadPreset, OtherFormat_IsAnError) {
    EXPECT_EQ(messages({{"format", "other"}}), "this is no preset; expected \"format\": "
                                               "\"patina.preset\", as every preset has it\n");
}

TEST(ReadPreset, EmptyObject_IsAnError) {
    EXPECT_EQ(readingOf("{}").error().size(), 3u);
}

TEST(ReadPreset, Array_IsAnError) {
    EXPECT_FALSE(readingOf("[]"));
}

TEST(ReadPreset, WrongTypeAnywhere_IsAnErrorAndNoCrash) {
    const json keys = toJson(Material{});
    for (const auto& [key, ignored] : keys.items()) {
        for (const json& wrong : {json(5), json("x"), json::array({json::object()}), json(true)}) {
            json preset = plainPreset();
            preset[key] = wrong;
            const auto read = readingOf(writeJson(preset));
            EXPECT_TRUE(!read || json(toJson(read->material)[key]).type() == wrong.type() ||
                        !read->notes.empty())
                << key << " " << wrong;
        }
    }
}

TEST(ReadPreset, FormerId_IsUsedForAnOldVersion) {
    json preset = plainPreset();
    preset["model"]["version"] = 1;
    preset["parameters"] = {{"hair", 0.5}};
    const auto read = readingOf(writeJson(preset));
    EXPECT_EQ(read->material.model.parameters.at("fuzz"), Value(0.5));
    EXPECT_EQ(text(read->notes), "");
}

TEST(ReadPreset, FormerId_IsUnknownInANewVersion) {
    EXPECT_NE(messages({{"parameters", {{"hair", 0.5}}}}), "");
}

TEST(ReadPreset, NewerModel_IsNoted) {
    EXPECT_NE(messages({{"model", {{"version", 3}}}}).find("has version 3 here"),
              std::string::npos);
}

TEST(ReadPreset, UnknownLevel_IsExactWithANote) {
    const auto read = reading({{"accuracy", {{"sum", "rough"}}}});
    EXPECT_EQ(read->material.accuracy.at("sum"), "full");
    EXPECT_EQ(read->notes.size(), 1u);
}

TEST(ReadPreset, MissingLevel_IsExact) {
    EXPECT_EQ(reading(json::object())->material.accuracy.at("sum"), "full");
}

TEST(ReadPreset, NoFresnel_IsOff) {
    EXPECT_EQ(reading({{"fresnel", nullptr}})->material.part("fresnel"), nullptr);
}

TEST(ReadPreset, Fresnel_HasItsValues) {
    const Material material =
        reading({{"fresnel", {{"id", "coat"}, {"parameters", {{"gloss", 0.125}}}}}})->material;
    EXPECT_EQ(material.part("fresnel")->parameters, (Values{{"gloss", 0.125}}));
}

TEST(ReadPreset, UnknownHighlight_IsWrittenBackAsItCame) {
    const json highlight = {{"id", "not-here"}, {"version", 3}, {"parameters", {{"size", 0.25}}}};
    EXPECT_EQ(toJson(reading({{"specular", highlight}})->material)["specular"], highlight);
}

TEST(ReadPreset, OpacityAboveOne_IsBroughtInWithANote) {
    const auto read = reading({{"opacity", 3}});
    EXPECT_EQ(read->material.opacity, 1.0);
    EXPECT_EQ(read->notes.size(), 1u);
}

TEST(ReadPreset, TextureOutsideTheFolder_IsNoted) {
    EXPECT_NE(messages({{"textures", {{"color", {{"file", "../secret.png"}}}}}})
                  .find("\"../secret.png\" is not in the preset's folder"),
              std::string::npos);
}

TEST(ReadPreset, TextureInTheFolder_IsFine) {
    EXPECT_EQ(messages({{"textures", {{"color", {{"file", "maps/wood.png"}}}}}}), "");
}

TEST(StaysInFolder, PathsThatLeave_AreFound) {
    for (const char* path : {"../a", "a/../../b", "/etc/passwd", "C:/a", "..\\a", "\\\\host\\a",
                             "..", "a/b/../../../c", ""}) {
        EXPECT_FALSE(staysInFolder(path)) << path;
    }
}

TEST(StaysInFolder, PathsThatStay_AreAllowed) {
    for (const char* path : {"a.png", "./a.png", "a/b.png", "a/../b.png", "..a/b"}) {
        EXPECT_TRUE(staysInFolder(path)) << path;
    }
}

/// A preset with an unknown key in every object.
json presetWithUnknownKeys() {
    json preset = toJson(reading({{"fresnel", {{"id", "coat"}}}})->material);
    const json odd{{"a", {1, 2.5, nullptr, {{"b", "c"}}}}, {"big", 123456789012345678}};
    for (const char* place : {"", "/model", "/parameters", "/fresnel", "/fresnel/parameters",
                              "/extras", "/parked", "/textures"}) {
        preset[json::json_pointer(place)]["x-odd"] = odd;
    }
    return preset;
}

TEST(WritePreset, UnknownKeysOfEveryObject_AreWrittenBackUntouched) {
    const std::string before = writeJson(presetWithUnknownKeys());
    EXPECT_EQ(writeJson(toJson(readingOf(before)->material)), before);
}

TEST(WritePreset, EveryParameter_IsWritten) {
    EXPECT_EQ(toJson(reading(json::object())->material)["parameters"].size(), 4u);
}

TEST(WritePreset, Written_ReadsAsTheSameMaterial) {
    const Material before =
        reading({{"name", "N"}, {"tags", {"a", "b"}}, {"opacity", 0.3}})->material;
    EXPECT_EQ(readingOf(writeJson(toJson(before)))->material, before);
}

TEST(WritePreset, File_ReadsAsTheSameMaterial) {
    const tests::TemporaryFolder folder;
    const Material before = reading(json::object())->material;
    ASSERT_TRUE(writePreset(folder / "a.patina.json", before, presetCatalog()));
    EXPECT_EQ(readPreset(folder / "a.patina.json", presetCatalog())->material, before);
}

TEST(WritePreset, Written_FollowsTheSchema) {
    const auto document = parseJson(writeJson(presetWithUnknownKeys()), "p");
    EXPECT_EQ(text(checkSchema(*document, "preset")), "");
}

TEST(PresetSchema, WrongTypes_AreReported) {
    const auto document = parseJson("{\"format\": \"patina.preset\", \"version\": \"1\",\n"
                                    "\"model\": 5, \"opacity\": -1}",
                                    "p");
    EXPECT_EQ(checkSchema(*document, "preset").size(), 3u);
}

} // namespace
} // namespace patina::preset_file_test
