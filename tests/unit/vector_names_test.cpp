// SPDX-License-Identifier: GPL-3.0-or-later
// What a descriptor calls the numbers of a vector.
#include <gtest/gtest.h>

#include "catalog_fixture.h"

namespace patina::vector_names_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

json vectorDescriptor() {
    json descriptor = plainDescriptor("a");
    descriptor["parameters"][0].merge_patch(
        {{"type", "vec3"}, {"default", {0, 0, 0}}, {"min", 0}, {"max", 1}});
    return descriptor;
}

class VectorNames : public testing::Test {
  protected:
    Catalog load(const json& descriptor) const {
        folder_.add("models", descriptor);
        return folder_.load();
    }
    std::string mistakes(const json& descriptor) const { return text(load(descriptor).errors); }

  private:
    mutable BlockFolder folder_;
};

TEST_F(VectorNames, WithoutThem_AreXYZ) {
    const Catalog catalog = load(vectorDescriptor());
    ASSERT_EQ(catalog.blocks.size(), 1u) << text(catalog.errors);
    EXPECT_EQ(toJson(catalog.blocks[0])["parameters"][0]["components"], json({"x", "y", "z"}));
}

TEST_F(VectorNames, Written_AreADescriptorOfTheSameBlock) {
    json descriptor = vectorDescriptor();
    descriptor["parameters"][0]["components"] = {"R", "G", "B"};
    const Catalog before = load(descriptor);
    ASSERT_EQ(before.blocks.size(), 1u) << text(before.errors);
    json again = toJson(before.blocks[0]);
    EXPECT_EQ(again["parameters"][0]["components"], json({"R", "G", "B"}));
    again.erase("kind");
    EXPECT_EQ(load(again), before);
}

TEST_F(VectorNames, OfANumber_AreAMistake) {
    json descriptor = plainDescriptor("a");
    descriptor["parameters"][0]["components"] = {"R", "G", "B"};
    EXPECT_NE(mistakes(descriptor).find("only a vec2 or a vec3 has components; expected no such "
                                        "key"),
              std::string::npos);
}

TEST_F(VectorNames, TwoForThreeNumbers_AreAMistake) {
    json descriptor = vectorDescriptor();
    descriptor["parameters"][0]["components"] = {"R", "G"};
    EXPECT_NE(mistakes(descriptor).find("2 names for 3 numbers; expected a name for each"),
              std::string::npos);
}

} // namespace
} // namespace patina::vector_names_test
