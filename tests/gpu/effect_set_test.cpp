// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_set.h"

#include "shading/effects/effect_key.h"
#include "shading_scene.h"

namespace patina::effect_set_test {
namespace {

class EffectSetTest : public ShadingTest {
  protected:
    static Scene lit(const Light& one) {
        Scene scene;
        scene.lights = {one};
        return scene;
    }

    static EffectSet effectsOf(const Light& one) { return sceneEffects(lit(one), catalog()); }
};

TEST_F(EffectSetTest, LightsOfOneKind_AreOneGroup) {
    Scene scene;
    scene.lights = {light("point"), light("head"), light("point")};
    const EffectSet effects = sceneEffects(scene, catalog());
    ASSERT_EQ(effects.lights.size(), 2u);
    EXPECT_EQ(effects.lights[1].lines, 2);
}

TEST_F(EffectSetTest, DifferentCompiledValues_AreTwoGroups) {
    Scene scene;
    scene.lights = {light("point"), light("point")};
    scene.lights[1].block.parameters["falloff"] = std::string("inverse-square");
    EXPECT_EQ(sceneEffects(scene, catalog()).lights.size(), 2u);
}

TEST_F(EffectSetTest, DisabledLight_IsLeftOutWithAReason) {
    Light off = light("point");
    off.enabled = false;
    EXPECT_TRUE(effectsOf(off).lights.empty());
    ASSERT_EQ(leftOutOf(lit(off)).size(), 1u);
    EXPECT_EQ(leftOutOf(lit(off))[0].reason, "It is switched off.");
}

TEST_F(EffectSetTest, BlackLight_IsLeftOut) {
    Light black = light("spot");
    black.block.parameters["color"] = glm::dvec3(0.0);
    EXPECT_TRUE(effectsOf(black).lights.empty());
}

TEST_F(EffectSetTest, LightWithoutIntensity_IsLeftOut) {
    Light dark = light("directional");
    dark.block.parameters["intensity"] = 0.0;
    EXPECT_TRUE(effectsOf(dark).lights.empty());
}

TEST_F(EffectSetTest, UnknownLight_IsLeftOutWithItsName) {
    Light unknown;
    unknown.block.id = "moonbeam";
    ASSERT_EQ(leftOutOf(lit(unknown)).size(), 1u);
    EXPECT_NE(leftOutOf(lit(unknown))[0].reason.find("moonbeam"), std::string::npos);
}

TEST_F(EffectSetTest, FogWithoutDensity_IsLeftOut) {
    Scene scene;
    scene.setPart(kinds::fog, block("fog", "exponential"));
    scene.part(kinds::fog)->parameters["density"] = 0.0;
    EXPECT_FALSE(sceneEffects(scene, catalog()).fog);
}

TEST_F(EffectSetTest, DarkEnvironment_IsLeftOutWithAReason) {
    Scene scene;
    scene.setPart(kinds::environment, block("environment", "studio"));
    EffectKey keys;
    const std::uint64_t lit = keys.ofScene(scene, catalog());
    EXPECT_TRUE(sceneEffects(scene, catalog()).environment);
    scene.part(kinds::environment)->parameters["intensity"] = 0.0;
    const EffectSet effects = sceneEffects(scene, catalog());
    EXPECT_FALSE(effects.environment);
    ASSERT_EQ(leftOutOf(scene).size(), 1u);
    EXPECT_EQ(leftOutOf(scene)[0].reason, "It is dark. Its “Intensity” is 0.");
    EXPECT_NE(keys.ofScene(scene, catalog()), lit);
}

TEST_F(EffectSetTest, EnvironmentWithoutItsPicture_IsLeftOutWithAReason) {
    Scene scene;
    scene.setPart(kinds::environment, block("environment", "image"));
    const EffectSet effects = sceneEffects(scene, catalog());
    EXPECT_FALSE(effects.environment);
    ASSERT_EQ(leftOutOf(scene).size(), 1u);
    EXPECT_EQ(leftOutOf(scene)[0].reason, "No picture is chosen for it.");
}

TEST_F(EffectSetTest, UnknownEnvironment_IsLeftOut) {
    Scene scene;
    scene.parts["environment"].id = "moonscape";
    EXPECT_FALSE(sceneEffects(scene, catalog()).environment);
    EXPECT_EQ(leftOutOf(scene).size(), 1u);
}

TEST_F(EffectSetTest, Hemisphere_IsInWhereOneHalfIsNotBlack) {
    Scene scene;
    EffectKey keys;
    const std::uint64_t before = keys.ofScene(scene, catalog());
    EXPECT_FALSE(sceneEffects(scene, catalog()).hemisphere);
    scene.hemisphere.sky = glm::dvec3(0.0, 0.0, 0.2);
    EXPECT_TRUE(sceneEffects(scene, catalog()).hemisphere);
    EXPECT_NE(keys.ofScene(scene, catalog()), before);
}

TEST_F(EffectSetTest, ModelWithSlot_TakesTheMaterialsFresnel) {
    Material metal = material("cook-torrance");
    metal.parts["fresnel"] = block("fresnel", "dielectric");
    const EffectSet set = effectSet(metal, {}, catalog());
    ASSERT_EQ(set.slots.size(), 1u);
    EXPECT_EQ(set.slots[0].block().id, "dielectric");
    EXPECT_FALSE(set.blend);
}

TEST_F(EffectSetTest, EmptySlot_TakesTheDefaultBlock) {
    const EffectSet set = effectSet(material("cook-torrance"), {}, catalog());
    ASSERT_EQ(set.slots.size(), 1u);
    EXPECT_EQ(set.slots[0].block().id,
              catalog().find("models", "cook-torrance")->slots[0].defaultBlock);
}

TEST_F(EffectSetTest, OpenSlot_StaysEmptyUntilSomethingIsChosen) {
    Material matte = material("lambert");
    EXPECT_TRUE(effectSet(matte, {}, catalog()).slots.empty());
    matte.parts["specular"] = block("specular", "gaussian");
    const EffectSet set = effectSet(matte, {}, catalog());
    ASSERT_EQ(set.slots.size(), 1u);
    EXPECT_EQ(set.slots[0].block().id, "gaussian");
}

TEST_F(EffectSetTest, PartWithoutASlot_IsNamedAsLeftOut) {
    Material shiny = material("phong");
    shiny.parts["specular"] = block("specular", "gaussian");
    const EffectSet set = effectSet(shiny, {}, catalog());
    EXPECT_TRUE(set.slots.empty());
    ASSERT_FALSE(leftOutOf(shiny, {}).empty());
    EXPECT_EQ(leftOutOf(shiny, {})[0].effect, "specular/gaussian");
}

TEST_F(EffectSetTest, Emission_IsInOnlyWhereItIsNotBlack) {
    Material glowing = material("lambert");
    EXPECT_TRUE(effectSet(glowing, {}, catalog()).emission.empty());
    const std::uint64_t before = EffectKey::ofMaterial(glowing, catalog());
    glowing.model.parameters["emissive.color"] = glm::dvec3(0.0, 0.2, 0.0);
    const EffectSet set = effectSet(glowing, {}, catalog());
    ASSERT_EQ(set.emission.size(), 1u);
    EXPECT_EQ(set.emission[0]->id, "emissive.color");
    EXPECT_NE(EffectKey::ofMaterial(glowing, catalog()), before);
}

TEST_F(EffectSetTest, ModelWithoutSlot_IsBlended) {
    Material matte = material("lambert");
    matte.parts["fresnel"] = block("fresnel", "schlick");
    EXPECT_TRUE(effectSet(matte, {}, catalog()).blend);
}

TEST_F(EffectSetTest, EveryEffect_HasAReason) {
    Material glass = material("strauss");
    glass.parts["fresnel"] = block("fresnel", "schlick");
    glass.opacity = 0.5;
    Scene scene;
    scene.lights = {light("point")};
    scene.setPart(kinds::fog, block("fog", "linear"));
    scene.ambient = glm::dvec3(0.1);
    const std::vector<EffectLine> lines =
        effectLines(effectSet(glass, scene, catalog()), {&glass, scene, catalog(), {}});
    ASSERT_EQ(lines.size(), 6u);
    for (const EffectLine& line : lines) {
        EXPECT_TRUE(line.reason.ends_with('.')) << line.effect;
    }
}

/// A sphere in one light with shadows.
class ShadowEffects : public ShadingTest {
  protected:
    static Scene shadowed(const std::string& kindOfLight, const std::string& kindOfShadow) {
        Scene scene;
        scene.objects.emplace_back();
        scene.objects[0].material = material("lambert");
        scene.lights = {light(kindOfLight)};
        scene.lights[0].setPart(kinds::shadows, block("shadows", kindOfShadow));
        return scene;
    }

    static std::string textOf(const Scene& scene) {
        return fragment(scene.objects[0].material, scene);
    }
};

TEST_F(ShadowEffects, Shadow_IsInTheGroupOfItsLight) {
    const Scene scene = shadowed("point", "soft");
    const EffectSet effects = sceneEffects(scene, catalog());
    ASSERT_EQ(effects.lights.size(), 1u);
    ASSERT_TRUE(effects.lights[0].shadow);
    EXPECT_EQ(effects.lights[0].shadow->block().id, "soft");
    EXPECT_EQ(effects.lights[0].projection(), ShadowProjection::Sphere);
}

TEST_F(ShadowEffects, LightsWithAndWithout_AreGroupsOfTheirOwn) {
    Scene scene = shadowed("point", "soft");
    scene.lights.push_back(light("point"));
    EXPECT_EQ(sceneEffects(scene, catalog()).lights.size(), 2u);
}

TEST_F(ShadowEffects, WithoutCaster_AreLeftOutWithAReason) {
    Scene scene = shadowed("point", "soft");
    scene.objects[0].castsShadow = false;
    const EffectSet effects = sceneEffects(scene, catalog());
    EXPECT_FALSE(effects.lights[0].shadow);
    ASSERT_EQ(leftOutOf(scene).size(), 1u);
    EXPECT_EQ(leftOutOf(scene)[0].reason, "No object casts a shadow: 1 is set to cast none.");
    EXPECT_EQ(textOf(scene).find("hadow"), std::string::npos);
}

TEST_F(ShadowEffects, OfOneProjection_HaveNothingOfTheOtherInTheText) {
    EXPECT_EQ(textOf(shadowed("directional", "hard")).find("localShadow"), std::string::npos);
    EXPECT_EQ(textOf(shadowed("spot", "hard")).find("parallelShadow"), std::string::npos);
}

TEST_F(ShadowEffects, Key_DiffersExactlyWhereTheTextDoes) {
    std::vector<Scene> scenes{shadowed("point", "soft"), shadowed("point", "hard"),
                              shadowed("point", "filtered"), shadowed("spot", "soft")};
    scenes.push_back(scenes[0]);
    scenes.back().objects[0].castsShadow = false;
    scenes.push_back(scenes[0]);
    scenes.back().objects[0].material.opacity = 0.4; // casts none either, and is no longer solid
    scenes.push_back(scenes[0]);
    scenes.back().lights[0].setPart(kinds::shadows, std::nullopt);
    scenes.push_back(scenes[0]);
    scenes.back().lights[0].part(kinds::shadows)->parameters["samples"] = std::string("fine");
    scenes.push_back(scenes[0]);
    scenes.back().lights[0].part(kinds::shadows)->parameters["size"] = 0.7;
    EffectKey keys;
    for (const Scene& a : scenes) {
        for (const Scene& b : scenes) {
            const bool sameKey = keys.ofScene(a, catalog()) == keys.ofScene(b, catalog());
            EXPECT_EQ(sameKey,
                      sceneEffects(a, catalog()).lights == sceneEffects(b, catalog()).lights);
        }
    }
}

TEST_F(EffectSetTest, Key_StaysWhenAValueChanges) {
    Material phong = material("phong");
    const std::uint64_t before = EffectKey::ofMaterial(phong, catalog());
    phong.model.parameters["shininess"] = 321.0;
    EXPECT_EQ(EffectKey::ofMaterial(phong, catalog()), before);
}

TEST_F(EffectSetTest, Key_ChangesWithACompiledValue) {
    Material metal = material("cook-torrance");
    metal.model.parameters["distribution"] = std::string("beckmann");
    const std::uint64_t before = EffectKey::ofMaterial(metal, catalog());
    metal.model.parameters["distribution"] = std::string("ggx");
    EXPECT_NE(EffectKey::ofMaterial(metal, catalog()), before);
}

TEST_F(EffectSetTest, EqualRoughness_IsKnownInTheProgram) {
    Material metal = material("ward");
    metal.model.parameters["roughness.x"] = 0.3;
    metal.model.parameters["roughness.y"] = 0.31;
    const std::uint64_t before = EffectKey::ofMaterial(metal, catalog());
    EXPECT_NE(fragment(metal, {}).find("roughnessYEqual = false"), std::string::npos);
    metal.model.parameters["roughness.y"] = 0.3;
    EXPECT_NE(fragment(metal, {}).find("roughnessYEqual = true"), std::string::npos);
    EXPECT_NE(EffectKey::ofMaterial(metal, catalog()), before);
}

} // namespace
} // namespace patina::effect_set_test
