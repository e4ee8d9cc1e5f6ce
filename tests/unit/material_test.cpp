// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material.h"

#include <gtest/gtest.h>

#include "material/reconciled.h"

namespace patina::material_test {
namespace {

Parameter number(std::string id, double defaultValue, double max = 1.0) {
    Parameter made;
    made.id = std::move(id);
    made.defaultValue = defaultValue;
    made.max = max;
    return made;
}

Parameter choice(std::string id, const std::vector<std::string>& values) {
    Parameter made;
    made.id = std::move(id);
    made.type = ParameterType::Enum;
    for (const std::string& value : values) {
        made.values.push_back({value, "", "", false});
    }
    made.defaultValue = values.front();
    return made;
}

Block block(std::string id, std::vector<Parameter> parameters) {
    Block made;
    made.kind = "models";
    made.label = made.id = std::move(id);
    made.parameters = std::move(parameters);
    return made;
}

const Block matte = block("matte", {number("albedo", 0.5)});
const Block shiny = block("shiny", {number("albedo", 0.25), number("gloss", 0.5, 1000.0)});
const Block dull = block("dull", {number("gloss", 0.1, 10.0)});

Value get(const Material& material, const std::string& id) {
    return material.model.parameters.at(id);
}

Material shinyMaterial(double gloss) {
    Material material = defaultMaterial(shiny);
    material.model.parameters["gloss"] = gloss;
    return material;
}

TEST(DefaultMaterial, EveryParameter_HasItsDefault) {
    EXPECT_EQ(defaultMaterial(shiny).model.parameters, (Values{{"albedo", 0.25}, {"gloss", 0.5}}));
}

TEST(DefaultMaterial, EveryAccuracyChoice_IsExact) {
    Block chosen = matte;
    chosen.accuracy = {{"lobe", "", "", {{"full", "", "", true}, {"fast", "", "", false}}}};
    EXPECT_EQ(defaultMaterial(chosen).accuracy, (AccuracyLevels{{"lobe", "full"}}));
}

TEST(WithModel, SameId_CarriesOver) {
    Material material = shinyMaterial(0.5);
    material.model.parameters["albedo"] = 0.75;
    EXPECT_EQ(get(withModel(material, &shiny, matte), "albedo"), Value(0.75));
}

TEST(WithModel, UnusedValue_IsParked) {
    EXPECT_EQ(withModel(shinyMaterial(0.75), &shiny, matte).parked["gloss"], 0.75);
}

TEST(WithModel, SwappedBack_IsTheSameMaterial) {
    const Material before = shinyMaterial(0.75);
    EXPECT_EQ(withModel(withModel(before, &shiny, matte), &matte, shiny), before);
}

TEST(WithModel, SwappedBackThroughAThird_KeepsTheValue) {
    const Material away = withModel(shinyMaterial(5.0), &shiny, matte);
    EXPECT_EQ(get(withModel(away, &matte, dull), "gloss"), Value(5.0));
}

TEST(WithModel, NewerValue_WinsOverTheParkedOne) {
    Material material = withModel(withModel(shinyMaterial(5.0), &shiny, matte), &matte, dull);
    material.model.parameters["gloss"] = 7.0;
    EXPECT_EQ(get(withModel(material, &dull, shiny), "gloss"), Value(7.0));
}

TEST(WithModel, ValueOutsideTheNewRange_IsBroughtIn) {
    EXPECT_EQ(get(withModel(shinyMaterial(500.0), &shiny, dull), "gloss"), Value(10.0));
}

TEST(WithModel, ValueBroughtToAnEndThatIsNoFloat_IsAFloatAndComesBackWhole) {
    const Block tenth = block("tenth", {number("gloss", 0.1, 0.1)});
    const Material before = shinyMaterial(500.0);
    const Material swapped = withModel(before, &shiny, tenth);
    EXPECT_EQ(get(swapped, "gloss"), Value(static_cast<double>(0.1f)));
    EXPECT_EQ(get(withModel(swapped, &tenth, shiny), "gloss"), Value(500.0));
}

TEST(WithModel, ValueThatWasBroughtIn_ComesBackWhole) {
    const Material before = shinyMaterial(500.0);
    EXPECT_EQ(get(withModel(withModel(before, &shiny, dull), &dull, shiny), "gloss"), Value(500.0));
}

TEST(WithModel, ValueThatWasBroughtInAndChanged_StaysChanged) {
    Material material = withModel(shinyMaterial(500.0), &shiny, dull);
    material.model.parameters["gloss"] = 3.0;
    EXPECT_EQ(get(withModel(material, &dull, shiny), "gloss"), Value(3.0));
}

TEST(WithModel, SameIdOfAnotherType_DoesNotCarryOver) {
    const Block other = block("other", {choice("gloss", {"low", "high"})});
    EXPECT_EQ(get(withModel(shinyMaterial(0.75), &shiny, other), "gloss"),
              Value(std::string("low")));
}

TEST(WithModel, SameIdOfAnotherType_ComesBack) {
    const Block other = block("other", {choice("gloss", {"low", "high"})});
    const Material before = shinyMaterial(0.75);
    EXPECT_EQ(get(withModel(withModel(before, &shiny, other), &other, shiny), "gloss"),
              Value(0.75));
}

TEST(WithModel, TwoTypesOfOneId_AreBothKeptByAThird) {
    const Block other = block("other", {choice("gloss", {"low", "high"})});
    Material material = withModel(shinyMaterial(0.75), &shiny, other);
    material.model.parameters["gloss"] = std::string("high");
    material = withModel(material, &other, matte);
    EXPECT_EQ(get(withModel(material, &matte, other), "gloss"), Value(std::string("high")));
    EXPECT_EQ(get(withModel(material, &matte, shiny), "gloss"), Value(0.75));
}

TEST(WithModel, ChoiceTheNewModelLacks_ComesBack) {
    const Block first = block("first", {choice("scale", {"a", "b"})});
    const Block second = block("second", {choice("scale", {"a", "c"})});
    Material material = defaultMaterial(first);
    material.model.parameters["scale"] = std::string("b");
    const Material swapped = withModel(material, &first, second);
    EXPECT_EQ(get(swapped, "scale"), Value(std::string("a")));
    EXPECT_EQ(get(withModel(swapped, &second, first), "scale"), Value(std::string("b")));
}

TEST(WithModel, UnknownOldModel_CarriesWhatFits) {
    Material material;
    material.model = {"gone", 1, {{"gloss", 0.75}, {"other", true}}, nlohmann::json::object()};
    const Material swapped = withModel(material, nullptr, shiny);
    EXPECT_EQ(get(swapped, "gloss"), Value(0.75));
    EXPECT_EQ(swapped.parked["other"], true);
}

TEST(WithModel, EverythingElse_Stays) {
    Material material = shinyMaterial(0.5);
    material.name = "N";
    material.tags = {"t"};
    material.extras = {{"x", 1}};
    Material swapped = withModel(material, &shiny, matte);
    swapped.model = material.model;
    swapped.parked = material.parked;
    EXPECT_EQ(swapped, material);
}

TEST(WithPart, On_HasTheDefaults) {
    const Material on = withPart(defaultMaterial(matte), "fresnel", nullptr, &shiny);
    EXPECT_EQ(on.part("fresnel")->parameters, defaultValues(shiny));
}

TEST(WithPart, OffAndOnAgain_IsTheSameMaterial) {
    Material material = withPart(defaultMaterial(matte), "fresnel", nullptr, &shiny);
    material.part("fresnel")->parameters["gloss"] = 0.125;
    const Material off = withPart(material, "fresnel", &shiny, nullptr);
    EXPECT_EQ(off.part("fresnel"), nullptr);
    EXPECT_EQ(withPart(off, "fresnel", nullptr, &shiny), material);
}

TEST(WithPart, Kinds_DoNotMix) {
    const Material one = withPart(defaultMaterial(matte), "fresnel", nullptr, &shiny);
    Material both = withPart(one, "specular", nullptr, &shiny);
    both.part("specular")->parameters["gloss"] = 0.25;
    const Material off = withPart(both, "specular", &shiny, nullptr);
    EXPECT_EQ(off.part("fresnel")->parameters, defaultValues(shiny));
    EXPECT_EQ(withPart(off, "specular", nullptr, &shiny), both);
}

TEST(WithPart, ParkedValues_AreNotTheModels) {
    Material material = withPart(defaultMaterial(matte), "fresnel", nullptr, &shiny);
    material.part("fresnel")->parameters["gloss"] = 0.125;
    const Material off = withPart(material, "fresnel", &shiny, nullptr);
    EXPECT_EQ(get(withModel(off, &matte, shiny), "gloss"), Value(0.5));
}

Catalog catalogOf(const Block& only) {
    Catalog catalog;
    catalog.blocks = {only};
    return catalog;
}

TEST(Reconciled, RemovedParameter_ComesBackWithTheDescriptor) {
    Block without = shiny;
    without.parameters.pop_back();
    const Material before = shinyMaterial(0.75);
    const Material between = reconciled(before, catalogOf(shiny), catalogOf(without));
    EXPECT_FALSE(between.model.parameters.contains("gloss"));
    EXPECT_EQ(reconciled(between, catalogOf(without), catalogOf(shiny)), before);
}

TEST(Reconciled, AddedParameter_HasItsDefault) {
    Block more = matte;
    more.parameters.push_back(number("sheen", 0.125));
    const Material material = reconciled(defaultMaterial(matte), catalogOf(matte), catalogOf(more));
    EXPECT_EQ(get(material, "sheen"), Value(0.125));
}

TEST(Reconciled, BlockThatIsGone_StaysAsItWas) {
    const Material before = shinyMaterial(0.75);
    EXPECT_EQ(reconciled(before, catalogOf(shiny), Catalog{}), before);
}

TEST(Reconciled, LightsRemovedParameter_ComesBack) {
    Block lamp = shiny;
    lamp.kind = "lights";
    Block without = lamp;
    without.parameters.pop_back();
    const BlockValues before{
        "shiny", 1, {{"albedo", 0.5}, {"gloss", 7.0}}, nlohmann::json::object()};
    const BlockValues between = reconciled(before, "lights", catalogOf(lamp), catalogOf(without));
    EXPECT_EQ(reconciled(between, "lights", catalogOf(without), catalogOf(lamp)), before);
}

} // namespace
} // namespace patina::material_test
