// SPDX-License-Identifier: GPL-3.0-or-later
// Presets that keep only what differs from another one.
#include "material/variant.h"

#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "schema_check.h"

namespace patina::variant_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;
using tests::readFile;
using tests::writeFile;

json floatParameter(const std::string& id) {
    return {{"id", id}, {"label", id}, {"type", "float"}, {"default", 0.25}};
}

Catalog madeCatalog() {
    BlockFolder folder;
    json velvet = plainDescriptor("velvet");
    velvet["parameters"] = {floatParameter("fuzz"), floatParameter("soft")};
    folder.add("models", velvet);
    json silk = plainDescriptor("silk");
    silk["parameters"] = {floatParameter("fuzz"), floatParameter("sheen")};
    folder.add("models", silk);
    folder.add("fresnel", plainDescriptor("coat"));
    return folder.load();
}

const Catalog& catalog() {
    static const Catalog made = madeCatalog();
    return made;
}

/// A folder with a preset "parent" and what tests write beside it.
class Variant : public testing::Test {
  protected:
    Variant() {
        write("parent", {{"name", "Parent"},
                         {"tags", {"cloth"}},
                         {"model", {{"id", "velvet"}, {"version", 1}}},
                         {"parameters", {{"fuzz", 0.5}, {"soft", 0.75}}},
                         {"fresnel", {{"id", "coat"}, {"version", 1}}}});
        write("child", {{"name", "Child"},
                        {"parent", "parent.patina.json"},
                        {"parameters", {{"fuzz", 0.125}}}});
    }

    std::filesystem::path fileOf(const std::string& name) const {
        return folder_ / (name + ".patina.json");
    }
    void write(const std::string& name, json preset) const {
        preset["format"] = "patina.preset";
        preset["version"] = 1;
        writeFile(fileOf(name), writeJson(preset));
    }
    Checked<PresetReading> read(const std::string& name) const {
        return readPreset(fileOf(name), catalog());
    }
    std::string problem(const std::string& name) const {
        const auto reading = read(name);
        return reading ? "" : text(reading.error());
    }
    static Value valueOf(const Checked<PresetReading>& reading, const std::string& id) {
        return reading->material.model.parameters.at(id);
    }

    tests::TemporaryFolder folder_;
};

TEST_F(Variant, OwnValues_OverlayTheParents) {
    const auto child = read("child");
    ASSERT_TRUE(child) << problem("child");
    EXPECT_EQ(valueOf(child, "fuzz"), Value(0.125));
    EXPECT_EQ(valueOf(child, "soft"), Value(0.75));
    EXPECT_EQ(child->material.name, "Child");
    EXPECT_EQ(child->material.tags, std::vector<std::string>{"cloth"});
    EXPECT_NE(child->material.part("fresnel"), nullptr);
    EXPECT_EQ(child->parents, std::vector{fileOf("parent")});
    EXPECT_EQ(text(child->notes), "");
}

TEST_F(Variant, Written_HoldsOnlyWhatDiffers) {
    Material material = read("child")->material;
    material.model.parameters["soft"] = Value(0.5);
    ASSERT_TRUE(writePreset(fileOf("child"), material, catalog()));
    const json written = json::parse(readFile(fileOf("child")));
    EXPECT_EQ(written, (json{{"format", "patina.preset"},
                             {"version", 1},
                             {"name", "Child"},
                             {"parent", "parent.patina.json"},
                             {"parameters", {{"fuzz", 0.125}, {"soft", 0.5}}}}));
    EXPECT_EQ(read("child")->material, material);
}

TEST_F(Variant, PartTakenAway_StaysAway) {
    Material material = read("child")->material;
    material.parts.clear();
    ASSERT_TRUE(writePreset(fileOf("child"), material, catalog()));
    EXPECT_EQ(read("child")->material.part("fresnel"), nullptr);
}

TEST_F(Variant, OfAnotherModel_CarriesValuesOverAsAChoiceOfTheModelDoes) {
    write("child",
          {{"name", "Child"}, {"parent", "parent.patina.json"}, {"model", {{"id", "silk"}}}});
    const auto child = read("child");
    ASSERT_TRUE(child) << problem("child");
    EXPECT_EQ(child->material.model.id, "silk");
    EXPECT_EQ(valueOf(child, "fuzz"), Value(0.5));
    EXPECT_EQ(text(child->notes), "");
    ASSERT_TRUE(writePreset(fileOf("child"), child->material, catalog()));
    EXPECT_EQ(read("child")->material, child->material);
}

TEST_F(Variant, MissingParent_IsNamedAtItsPlace) {
    std::filesystem::remove(fileOf("parent"));
    EXPECT_NE(problem("child").find("the parent \"parent.patina.json\" cannot be read"),
              std::string::npos)
        << problem("child");
    EXPECT_GT(read("child").error().front().line, 0);
}

TEST_F(Variant, CircleOfParents_IsAnError) {
    write("parent", {{"name", "Parent"}, {"parent", "child.patina.json"}});
    EXPECT_NE(problem("child").find("is a variant of this preset"), std::string::npos)
        << problem("child");
    write("child", {{"name", "Child"}, {"parent", "child.patina.json"}});
    EXPECT_NE(problem("child").find("is a variant of this preset"), std::string::npos);
}

TEST_F(Variant, TooManyAboveEachOther_AreAnError) {
    std::string above = "parent.patina.json";
    for (int i = 1; i <= maxParents + 1; ++i) {
        const std::string name = "v" + std::to_string(i);
        write(name, {{"name", name}, {"parent", above}});
        above = name + ".patina.json";
    }
    EXPECT_EQ(problem("v" + std::to_string(maxParents)), "");
    EXPECT_NE(problem("v" + std::to_string(maxParents + 1)).find("stand above each other"),
              std::string::npos);
}

TEST_F(Variant, ParentOutsideTheFolder_IsReadOnlyWithLeave) {
    const tests::TemporaryFolder elsewhere;
    std::filesystem::rename(fileOf("parent"), elsewhere / "parent.patina.json");
    const std::string there = (elsewhere / "parent.patina.json").string();
    write("child", {{"name", "Child"}, {"parent", there}});
    EXPECT_NE(problem("child").find("lies outside"), std::string::npos);
    EXPECT_EQ(parentsOutside(fileOf("child"), {}),
              (OutsideFiles{{OutsideFile::Kind::Preset, there}}));
    ReadingRights rights;
    rights.allowed.insert(there);
    EXPECT_TRUE(readPreset(fileOf("child"), catalog(), rights));
    EXPECT_TRUE(parentsOutside(fileOf("child"), rights).empty());
}

TEST_F(Variant, ParentThatIsNoText_IsAnError) {
    write("child", {{"name", "Child"}, {"parent", 5}});
    EXPECT_NE(problem("child"), "");
}

TEST_F(Variant, WrittenOverItsParent_IsWholeAndNoVariant) {
    const Material material = read("child")->material;
    ASSERT_TRUE(writePreset(fileOf("parent"), material, catalog()));
    const auto written = read("parent");
    ASSERT_TRUE(written) << problem("parent");
    EXPECT_EQ(parentOf(written->material), "");
    EXPECT_EQ(written->material.model, material.model);
}

TEST_F(Variant, WithoutItsParent_IsWrittenWhole) {
    const Material material = read("child")->material;
    std::filesystem::remove(fileOf("parent"));
    ASSERT_TRUE(writePreset(fileOf("child"), material, catalog()));
    EXPECT_EQ(valueOf(read("child"), "soft"), Value(0.75));
}

TEST_F(Variant, MovedToAnotherFolder_StillNamesItsParent) {
    const Material material = read("child")->material;
    std::filesystem::create_directories(folder_ / "below");
    ASSERT_TRUE(writePreset(folder_ / "below/child.patina.json", material, catalog()));
    const json written = json::parse(readFile(folder_ / "below/child.patina.json"));
    EXPECT_EQ(written["parent"], "../parent.patina.json");
}

TEST_F(Variant, Itself_FollowsTheSchema) {
    const auto document = readJson(fileOf("child"));
    EXPECT_EQ(text(checkSchema(*document, "preset")), "");
}

} // namespace
} // namespace patina::variant_test
