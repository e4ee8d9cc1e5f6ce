// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/parked.h"

#include <utility>

#include <gtest/gtest.h>

#include "catalog_fixture.h"
#include "material/model_swap.h"

namespace patina::parked_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

/// Two models of which each has a value of its own, and a Fresnel block.
Catalog madeCatalog() {
    BlockFolder folder;
    for (const auto& [id, own] : {std::pair("one", "ofOne"), std::pair("two", "ofTwo")}) {
        json model = plainDescriptor(id);
        json parameter = model["parameters"][0];
        parameter["id"] = own;
        model["parameters"].push_back(parameter);
        folder.add("models", model);
    }
    folder.add("fresnel", plainDescriptor("coat"));
    return folder.load();
}

const Catalog& catalog() {
    static const Catalog made = madeCatalog();
    return made;
}

Material swapped(const Material& material, const std::string& model) {
    return swappedModel(material, *catalog().find("models", model), catalog());
}

Material made() {
    Material material = defaultMaterial(*catalog().find("models", "one"));
    material.model.parameters["ofOne"] = 0.75;
    return material;
}

TEST(Parked, Catalog_HasNoMistakes) {
    EXPECT_EQ(catalog().errors, Errors());
}

TEST(Parked, ValuesOfAnotherModel_AreLeftOut) {
    const Material material = swapped(made(), "two");
    ASSERT_TRUE(material.parked.contains("ofOne"));
    Material expected = material;
    expected.parked = json::object();
    EXPECT_EQ(withoutParked(material, catalog()), expected);
}

TEST(Parked, ValueThatTheModelCouldNotUseAsItCame_Stays) {
    Material material = made();
    material.parked["gloss"] = "from a later version";
    EXPECT_EQ(withoutParked(material, catalog()), material);
}

TEST(Parked, ValuesOfAPartThatIsOff_AreLeftOut) {
    const Block* coat = catalog().find("fresnel", "coat");
    const Material on = withPart(made(), "fresnel", nullptr, coat);
    const Material off = withPart(on, "fresnel", coat, nullptr);
    ASSERT_FALSE(off.parked.empty());
    EXPECT_TRUE(withoutParked(off, catalog()).parked.empty());
}

TEST(Parked, WhereAModelIsNotInstalled_EverythingStays) {
    Material material = swapped(made(), "two");
    material.model.id = "unheard-of";
    EXPECT_EQ(withoutParked(material, catalog()), material);
}

} // namespace
} // namespace patina::parked_test
