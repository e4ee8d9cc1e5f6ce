// SPDX-License-Identifier: GPL-3.0-or-later
// What `--set` says of an id that nothing has, and which light it means.
#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "material/material_assignment.h"
#include "scene/scene_assignment.h"

namespace patina::assignment_test {
namespace {

const Catalog& shipped() {
    static const Catalog catalog = loadCatalog(standardBlockRoots());
    return catalog;
}

Light named(const char* name) {
    Light light;
    light.name = name;
    light.block.id = "directional";
    light.block.parameters = {{"intensity", 1.0}};
    return light;
}

Scene litBy(std::vector<Light> lights) {
    Scene scene;
    scene.lights = std::move(lights);
    return scene;
}

std::string problemIn(const Scene& scene, const std::string& text) {
    Scene copy = scene;
    const auto done = assignInScene(copy, text, shipped());
    return done ? std::string() : done.error().text();
}

std::string problemIn(const Material& material, const std::string& text) {
    Material copy = material;
    const auto done = assignInMaterial(copy, text, shipped());
    return done ? std::string() : done.error().text();
}

TEST(Assignment, InAPartThatIsNotThere_NamesThePart) {
    Material material = defaultMaterial(*shipped().find(kinds::models, "cook-torrance"));
    ASSERT_TRUE(choosePart(material, "fresnel", "schlick", shipped()));
    EXPECT_EQ(problemIn(material, "outline.width=3"),
              "the material has no outline; expected --outline");
    EXPECT_EQ(problemIn(material, "fresnel.nope=3").find("the fresnel \"schlick\" has no such"), 0u)
        << problemIn(material, "fresnel.nope=3");
}

TEST(Assignment, OfALightThatHasNone_ListsWhatEveryLightHas) {
    const std::string problem = problemIn(litBy({named("Key")}), "light.key.nope=1");
    EXPECT_NE(problem.find("intensity"), std::string::npos) << problem;
    EXPECT_NE(problem.find("enabled"), std::string::npos) << problem;
}

TEST(Assignment, OfALightWithADotInItsName_MeansThatLight) {
    Scene scene = litBy({named("Key"), named("Key.2")});
    const auto done = assignInScene(scene, "light.key.2.intensity=3", shipped());
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_EQ(scene.lights[0].block.parameters.at("intensity"), Value(1.0));
    EXPECT_EQ(scene.lights[1].block.parameters.at("intensity"), Value(3.0));
}

} // namespace
} // namespace patina::assignment_test
