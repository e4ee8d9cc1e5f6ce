// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the materials of mesh files, by the recipes that ship.

#include <gtest/gtest.h>

#include "material/mesh_look.h"

namespace patina::tests::mesh_look_test {
namespace {

const Catalog& shipped() {
    static const Catalog catalog =
        loadCatalog(std::vector<BlockRoot>{{dataFolder() / "shaders", true}});
    return catalog;
}

MeshMaterial everyValue(const std::string& look) {
    MeshMaterial material;
    material.name = "paint";
    material.look = look;
    for (const char* word : {"diffuse", "specular", "emissive", "f0"}) {
        material.values[word] = glm::dvec3(0.25, 0.5, 0.75);
    }
    material.values["metalness"] = glm::dvec3(0.5);
    material.values["shininess"] = glm::dvec3(40.0);
    material.values["alpha"] = glm::dvec3(0.125);
    material.values["opacity"] = glm::dvec3(0.5);
    return material;
}

class EveryMeshLook : public testing::TestWithParam<const char*> {};

TEST_P(EveryMeshLook, Material_HasTheColoursAndTheOpacityOfTheFile) {
    const auto material = materialOf(everyValue(GetParam()), shipped());
    ASSERT_TRUE(material) << material.error().text();
    EXPECT_EQ(material->name, "paint");
    EXPECT_EQ(material->opacity, 0.5);
    const glm::dvec3 base(0.25, 0.5, 0.75);
    const bool isMetal = std::string(GetParam()).ends_with("metal");
    EXPECT_EQ(material->model.parameters.at("diffuse.color"),
              Value(isMetal ? glm::dvec3(0.0) : base));
    EXPECT_EQ(material->model.parameters.at("emissive.color"), Value(base));
}

TEST_P(EveryMeshLook, Value_BeyondItsRange_IsBroughtIntoIt) {
    MeshMaterial bright = everyValue(GetParam());
    bright.values["emissive"] = glm::dvec3(1e9, -1.0, 0.5);
    const auto material = materialOf(bright, shipped());
    ASSERT_TRUE(material) << material.error().text();
    EXPECT_EQ(material->model.parameters.at("emissive.color"), Value(glm::dvec3(1000.0, 0.0, 0.5)));
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryMeshLook,
                         testing::Values("matte", "rough-matte", "phong", "blinn-phong",
                                         "dielectric", "metal", "metallic-roughness",
                                         "grained-dielectric", "grained-metal"));

TEST(MeshLook, Metal_HasItsReflectanceAndWidth) {
    const auto material = materialOf(everyValue("metal"), shipped());
    ASSERT_TRUE(material) << material.error().text();
    EXPECT_EQ(material->part("fresnel")->parameters.at("f0"), Value(glm::dvec3(0.25, 0.5, 0.75)));
    EXPECT_EQ(material->model.parameters.at("roughness"), Value(0.125));
    EXPECT_EQ(material->model.parameters.at("distribution"), Value(std::string("ggx")));
}

TEST(MeshLook, Images_LieOnTheParametersOfTheirWords) {
    MeshMaterial from = everyValue("blinn-phong");
    from.values["specular"] = glm::dvec3(0.0);
    from.images = {
        {"diffuse", "/a.png"}, {"specular", "/b.png"}, {"normal", "/n.png"}, {"f0", "/none.png"}};
    const auto material = materialOf(from, shipped());
    ASSERT_TRUE(material) << material.error().text();
    ASSERT_EQ(material->textures.size(), 3u);
    EXPECT_EQ(material->textures.at("diffuse.color").file, "/a.png");
    EXPECT_EQ(material->textures.at("diffuse.color").mode, TextureMode::Multiply);
    EXPECT_EQ(material->textures.at("specular.color").mode, TextureMode::Replace)
        << "nothing would be left of it";
    EXPECT_EQ(material->textures.at("normal").file, "/n.png");
}

TEST(MeshLook, ImageOfMetalnessAndRoughness_LiesOnBothByItsChannels) {
    MeshMaterial from = everyValue("metallic-roughness");
    from.images = {{"alpha", "/packed.png"}, {"metalness", "/packed.png"}};
    from.values["alpha.channel"] = glm::dvec3(1.0);
    from.values["alpha.root"] = glm::dvec3(1.0);
    from.values["metalness.channel"] = glm::dvec3(2.0);
    const auto material = materialOf(from, shipped());
    ASSERT_TRUE(material) << material.error().text();
    const TextureUse& width = material->textures.at("roughness");
    EXPECT_EQ(width.channel, TextureChannel::Green);
    EXPECT_EQ(width.colorSpace, TextureColorSpace::Roots);
    const TextureUse& metalness = material->textures.at("metalness");
    EXPECT_EQ(metalness.channel, TextureChannel::Blue);
    EXPECT_EQ(metalness.colorSpace, TextureColorSpace::Linear);
    EXPECT_EQ(metalness.mode, TextureMode::Multiply);
    EXPECT_EQ(material->model.parameters.at("metalness"), Value(0.5));
}

TEST(MeshLook, Unknown_SaysSo) {
    const auto material = materialOf(everyValue("velvet"), shipped());
    ASSERT_FALSE(material);
    EXPECT_EQ(material.error().problem, "there is no model for the look \"velvet\"");
}

} // namespace
} // namespace patina::tests::mesh_look_test
