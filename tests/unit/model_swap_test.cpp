// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/model_swap.h"

#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "material/preset_file.h"

namespace patina::model_swap_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

/// Two models that call a Fresnel block, two that do not, and two Fresnel blocks.
Catalog madeSwapCatalog() {
    BlockFolder folder;
    json slotted = plainDescriptor("slotted");
    slotted["slots"] = {{{"kind", "fresnel"}, {"default", "coat"}}};
    folder.add("models", slotted);
    slotted["id"] = "also-slotted";
    folder.add("models", slotted);
    folder.add("models", plainDescriptor("plain"));
    folder.add("models", plainDescriptor("also-plain"));
    folder.add("fresnel", plainDescriptor("coat"));
    folder.add("fresnel", plainDescriptor("film"));
    return folder.load();
}

const Catalog& swapCatalog() {
    static const Catalog made = madeSwapCatalog();
    return made;
}

Material made(const std::string& model) {
    return defaultMaterial(*swapCatalog().find("models", model));
}

Material with(const Material& material, const std::string& fresnel, double gloss) {
    Material next = withPart(material, "fresnel", nullptr, swapCatalog().find("fresnel", fresnel));
    next.parts.at("fresnel").parameters["gloss"] = gloss;
    return next;
}

Material swapped(const Material& material, const std::string& model) {
    return swappedModel(material, *swapCatalog().find("models", model), swapCatalog());
}

TEST(SwappedModel, TestCatalog_HasNoMistakes) {
    EXPECT_EQ(swapCatalog().errors, Errors());
}

TEST(SwappedModel, SlotsFilling_RestsWhereThereIsNoSlot) {
    EXPECT_EQ(swapped(with(made("slotted"), "coat", 0.75), "plain").part("fresnel"), nullptr);
}

TEST(SwappedModel, SlotsFilling_ComesBackWithTheSlot) {
    const Material before = with(made("slotted"), "film", 0.75);
    EXPECT_EQ(swapped(swapped(before, "plain"), "slotted"), before);
}

TEST(SwappedModel, SlotsFilling_ComesBackThroughAFile) {
    const Material before = with(made("slotted"), "film", 0.75);
    const LocatedJson file{"p", toJson(swapped(before, "plain")), {}};
    const auto reading = materialFromJson(file, "", swapCatalog());
    ASSERT_TRUE(reading);
    EXPECT_EQ(swapped(reading->material, "slotted"), before);
}

TEST(SwappedModel, SlotsFilling_KeepsWhatTheReaderDidNotKnow) {
    Material before = with(made("slotted"), "film", 0.75);
    before.parts.at("fresnel").unknown = {{"note", "by hand"}};
    EXPECT_EQ(swapped(swapped(before, "plain"), "slotted"), before);
}

TEST(SwappedModel, OneModelWithTheSlotForAnother_KeepsTheFilling) {
    const Material before = with(made("slotted"), "film", 0.75);
    EXPECT_EQ(swapped(before, "also-slotted").parts, before.parts);
}

TEST(SwappedModel, TurnedOnWithoutASlot_StaysOnThere) {
    const Material before = with(made("plain"), "film", 0.75);
    EXPECT_EQ(swapped(before, "also-plain").parts, before.parts);
}

TEST(SwappedModel, TurnedOnWithoutASlot_FillsASlotThatHadNothing) {
    const Material before = with(made("plain"), "film", 0.75);
    EXPECT_EQ(swapped(before, "slotted").parts, before.parts);
}

TEST(SwappedModel, TurnedOnWithoutASlot_ComesBackAfterASlot) {
    const Material before = with(made("plain"), "film", 0.75);
    EXPECT_EQ(swapped(swapped(before, "slotted"), "plain"), before);
}

TEST(SwappedModel, EachWithItsOwn_KeepsBoth) {
    const Material slot = with(made("slotted"), "coat", 0.25);
    const Material both = with(swapped(slot, "plain"), "film", 0.75);
    const Material back = swapped(both, "slotted");
    EXPECT_EQ(back.parts, slot.parts);
    EXPECT_EQ(swapped(back, "plain").parts, both.parts);
}

TEST(SwappedModel, TurnedOffInTheSlot_StaysOffThere) {
    Material material = swapped(with(made("plain"), "film", 0.75), "slotted");
    material = withPart(material, "fresnel", swapCatalog().find("fresnel", "film"), nullptr);
    EXPECT_EQ(swapped(swapped(material, "plain"), "slotted").part("fresnel"), nullptr);
}

/// A metal with a highlight and no diffuse colour, and two matte models.
Catalog coloredCatalog() {
    const auto color = [](const char* id, const json& value) {
        return json{{"id", id}, {"label", "Colour"}, {"type", "color"}, {"default", value}};
    };
    BlockFolder folder;
    json metal = plainDescriptor("metal");
    metal["parameters"] = {color("diffuse.color", {0.5, 0.5, 0.5}),
                           color("specular.color", {1, 1, 1})};
    folder.add("models", metal);
    for (const char* id : {"matte", "chalk"}) {
        json matte = plainDescriptor(id);
        matte["parameters"] = {color("diffuse.color", {0.25, 0.5, 0.75}),
                               color("emissive.color", {0, 0, 0})};
        matte["parameters"][1]["emission"] = true;
        folder.add("models", matte);
    }
    return folder.load();
}

class BlackColor : public testing::Test {
  protected:
    Material metal() const {
        Material material = defaultMaterial(*catalog.find("models", "metal"));
        material.model.parameters["diffuse.color"] = black;
        return material;
    }
    Material swapped(const Material& material, const std::string& model) const {
        return swappedModel(material, *catalog.find("models", model), catalog);
    }
    static Value diffuse(const Material& material) {
        return material.model.parameters.at("diffuse.color");
    }

    const Catalog catalog = coloredCatalog();
    const Value black = glm::dvec3(0.0);
    const Value usual = glm::dvec3(0.25, 0.5, 0.75);
};

TEST_F(BlackColor, OfAMetal_IsTheMatteModelsOwn) {
    EXPECT_EQ(diffuse(swapped(metal(), "matte")), usual);
}

/// A metal of a model without a Fresnel term has its colour in the highlight.
TEST(MetalsReflectance, WithASlot_IsAllThatItsHighlightHas) {
    const auto color = [](const char* id, const json& role) {
        json parameter{{"id", id}, {"label", id}, {"type", "color"}, {"default", {1, 1, 1}}};
        parameter.update(role);
        return parameter;
    };
    BlockFolder folder;
    for (const char* id : {"lobe", "facets"}) {
        json model = plainDescriptor(id);
        model["parameters"] = {color("diffuse.color", {{"role", "diffuse"}}),
                               color("specular.color", json::object())};
        if (id == std::string("facets")) {
            model["slots"] = {{{"kind", "fresnel"}, {"default", "coat"}}};
        }
        folder.add("models", model);
    }
    json coat = plainDescriptor("coat");
    coat["parameters"] =
        json::array({color("facing", {{"role", "f0"}, {"default", {0.04, 0.04, 0.04}}})});
    folder.add("fresnel", coat);
    const Catalog catalog = folder.load();
    ASSERT_EQ(catalog.errors, Errors());
    const auto facing = [&](const Material& material) {
        return swappedModel(material, *catalog.find("models", "facets"), catalog)
            .part("fresnel")
            ->parameters.at("facing");
    };
    Material lobe = defaultMaterial(*catalog.find("models", "lobe"));
    EXPECT_EQ(swappedModel(lobe, *catalog.find("models", "facets"), catalog).part("fresnel"),
              nullptr)
        << "a plastic has the usual one";
    lobe.model.parameters["diffuse.color"] = glm::dvec3(0.01);
    EXPECT_EQ(facing(lobe), Value(glm::dvec3(1.0)));
    Material facets = swappedModel(lobe, *catalog.find("models", "facets"), catalog);
    facets.parts.at("fresnel").parameters["facing"] = glm::dvec3(0.5);
    const Material back = swappedModel(facets, *catalog.find("models", "lobe"), catalog);
    EXPECT_EQ(facing(back), Value(glm::dvec3(0.5))) << "what was chosen comes back";
}

TEST_F(BlackColor, OfAMetal_ComesBackWithIt) {
    EXPECT_EQ(swapped(swapped(metal(), "matte"), "metal").model, metal().model);
}

TEST_F(BlackColor, OfAMetal_ComesBackAfterTwoMatteModels) {
    const Material second = swapped(swapped(metal(), "matte"), "chalk");
    EXPECT_EQ(diffuse(second), usual);
    EXPECT_EQ(swapped(second, "metal").model, metal().model);
}

TEST_F(BlackColor, ChosenOneMeanwhile_CarriesOver) {
    Material matte = swapped(metal(), "matte");
    matte.model.parameters["diffuse.color"] = glm::dvec3(1.0, 0.0, 0.0);
    EXPECT_EQ(diffuse(swapped(matte, "metal")), Value(glm::dvec3(1.0, 0.0, 0.0)));
}

TEST_F(BlackColor, OfAMatteModel_StaysBlack) {
    Material matte = defaultMaterial(*catalog.find("models", "matte"));
    matte.model.parameters["diffuse.color"] = black;
    EXPECT_EQ(diffuse(swapped(matte, "chalk")), black);
}

TEST_F(BlackColor, BesideAGlow_StaysBlack) {
    Material glowing = swapped(metal(), "matte");
    glowing.model.parameters["diffuse.color"] = black;
    glowing.model.parameters["emissive.color"] = glm::dvec3(1.0);
    EXPECT_EQ(diffuse(swapped(glowing, "chalk")), black);
}

TEST(SwappedModel, UnknownModelBefore_KeepsTheParts) {
    Material before = with(made("plain"), "film", 0.75);
    before.model.id = "gone";
    EXPECT_EQ(swapped(before, "plain").parts, before.parts);
}

} // namespace
} // namespace patina::model_swap_test
