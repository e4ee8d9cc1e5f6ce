// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/model_swap.h"

#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "material/preset_file.h"

namespace patina {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

/// Two models that call a Fresnel block, two that do not, and two Fresnel blocks.
Catalog testCatalog() {
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

const Catalog& catalog() {
    static const Catalog made = testCatalog();
    return made;
}

Material made(const std::string& model) {
    return defaultMaterial(*catalog().find("models", model));
}

Material with(const Material& material, const std::string& fresnel, double gloss) {
    Material next = withPart(material, "fresnel", nullptr, catalog().find("fresnel", fresnel));
    next.parts.at("fresnel").parameters["gloss"] = gloss;
    return next;
}

Material swapped(const Material& material, const std::string& model) {
    return swappedModel(material, *catalog().find("models", model), catalog());
}

TEST(SwappedModel, TestCatalog_HasNoMistakes) {
    EXPECT_EQ(catalog().errors, Errors());
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
    const auto reading = materialFromJson(file, "", catalog());
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
    material = withPart(material, "fresnel", catalog().find("fresnel", "film"), nullptr);
    EXPECT_EQ(swapped(swapped(material, "plain"), "slotted").part("fresnel"), nullptr);
}

TEST(SwappedModel, UnknownModelBefore_KeepsTheParts) {
    Material before = with(made("plain"), "film", 0.75);
    before.model.id = "gone";
    EXPECT_EQ(swapped(before, "plain").parts, before.parts);
}

} // namespace
} // namespace patina
