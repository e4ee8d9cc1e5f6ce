// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/blocks_in_use.h"

#include <gtest/gtest.h>

#include "catalog_fixture.h"

namespace patina::blocks_in_use_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

const Catalog& usedCatalog() {
    static const Catalog made = [] {
        BlockFolder folder;
        json slotted = plainDescriptor("slotted");
        slotted["slots"] = {{{"kind", "fresnel"}, {"default", "coat"}}};
        folder.add("models", slotted);
        folder.add("models", plainDescriptor("plain"));
        folder.add("fresnel", plainDescriptor("coat"));
        folder.add("fresnel", plainDescriptor("film"));
        folder.add("specular", plainDescriptor("spark"));
        return folder.load();
    }();
    return made;
}

Material made(const std::string& model) {
    return defaultMaterial(*usedCatalog().find("models", model));
}

Material with(const Material& material, const std::string& kind, const std::string& id) {
    return withPart(material, kind, nullptr, usedCatalog().find(kind, id));
}

std::string used(const Material& material) {
    std::string ids;
    for (const Block* block : blocksInUse(material, usedCatalog())) {
        ids += block->id + ' ';
    }
    return ids;
}

TEST(BlocksInUse, SlotThatNothingFills_HasItsDefault) {
    EXPECT_EQ(used(made("slotted")), "slotted coat ");
}

TEST(BlocksInUse, SlotThatAPartFills_HasThePart) {
    EXPECT_EQ(used(with(made("slotted"), "fresnel", "film")), "slotted film ");
}

TEST(BlocksInUse, BlendedFresnelBlock_IsOneOfThem) {
    EXPECT_EQ(used(with(made("plain"), "fresnel", "film")), "plain film ");
}

TEST(BlocksInUse, PartWithoutAPlace_IsNot) {
    EXPECT_EQ(used(with(made("plain"), "specular", "spark")), "plain ");
}

TEST(BlocksInUse, OfAModelThatIsNotKnown_AreNone) {
    Material material = made("plain");
    material.model.id = "gone";
    EXPECT_EQ(used(material), "");
}

} // namespace
} // namespace patina::blocks_in_use_test
