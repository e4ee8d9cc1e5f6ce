// SPDX-License-Identifier: GPL-3.0-or-later
// Why effects are in or out, and taking them out of a scene.
#include "shading/effects/effect_rows.h"

#include <algorithm>

#include "shading/effects/effect_key.h"
#include "shading/effects/effect_set.h"
#include "shading_scene.h"

namespace patina::effect_rows_test {
namespace {

class EffectRowsTest : public ShadingTest {
  protected:
    EffectRowsTest() {
        scene_.objects.emplace_back();
        scene_.objects[0].material = material("lambert");
    }

    std::vector<EffectRow> rows(double farthest = 10.0) const {
        return effectRows(scene_, 0, catalog(), {farthest});
    }

    /// The row of an effect; an empty one where there is none.
    EffectRow row(const std::string& effect, double farthest = 10.0) const {
        for (const EffectRow& each : rows(farthest)) {
            if (each.line.effect == effect) {
                return each;
            }
        }
        return {};
    }

    bool isIn(const std::string& effect, double farthest = 10.0) const {
        const EffectRow found = row(effect, farthest);
        return found.in && !found.line.effect.empty();
    }

    /// A scene with one effect of every kind that has a row.
    void useEverything() {
        Material& rich = scene_.objects[0].material;
        rich.parts["fresnel"] = block("fresnel", "schlick");
        rich.parts["specular"] = block("specular", "gaussian");
        rich.model.parameters["emissive.color"] = glm::dvec3(0.5);
        rich.opacity = 0.5;
        scene_.setPart(kinds::transparency, block("transparency", "peeled"));
        rich.textures["diffuse.color"] = textureUse("diffuse.color", "/wood.png");
        scene_.lights = {light("point"), light("head")};
        scene_.lights[0].setPart(kinds::shadows, block("shadows", "soft"));
        scene_.ground.mode = GroundMode::Plane;
        scene_.hemisphere.sky = glm::dvec3(0.2);
        scene_.setPart(kinds::environment, block("environment", "studio"));
        scene_.ambient = glm::dvec3(0.1);
        scene_.occlusion = true;
        scene_.setPart(kinds::fog, block("fog", "linear"));
        scene_.exposure = 1.0;
        scene_.setPart(kinds::tone, block("tone", "khronos-neutral"));
        scene_.passes = {block("pass", "kuwahara"), block("pass", "kuwahara")};
    }

    void useFog(const std::string& id, const std::string& parameter, double value) {
        scene_.setPart(kinds::fog, block("fog", id));
        scene_.part(kinds::fog)->parameters[parameter] = value;
    }

    Scene scene_;
};

TEST_F(EffectRowsTest, EveryRow_HasAReasonThatIsASentence) {
    useEverything();
    for (const EffectRow& each : rows()) {
        EXPECT_TRUE(each.line.reason.ends_with('.')) << each.line.effect;
    }
}

TEST_F(EffectRowsTest, NoEffect_HasTwoRows) {
    useEverything();
    std::vector<std::string> names;
    for (const EffectRow& each : rows()) {
        names.push_back(each.line.effect);
    }
    std::sort(names.begin(), names.end());
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

/// What makes rows of new effects complete: an entry in the table of removals.
TEST_F(EffectRowsTest, EveryEffectThatIsIn_CanBeLeftOut) {
    useEverything();
    const std::vector<EffectRow> all = rows();
    ASSERT_EQ(std::count_if(all.begin(), all.end(), [](const EffectRow& each) { return each.in; }),
              19);
    for (const EffectRow& each : all) {
        EXPECT_TRUE(each.removable || !each.in) << each.line.effect;
    }
}

TEST_F(EffectRowsTest, PassThatDoesNothing_IsOutWithItsReason) {
    scene_.passes = {block("pass", "kuwahara")};
    EXPECT_EQ(row("pass/kuwahara").line.detail, "sectors=eight, samples=normal");
    scene_.passes[0].parameters["radius"] = 0.0;
    EXPECT_FALSE(isIn("pass/kuwahara"));
    EXPECT_NE(row("pass/kuwahara").line.reason.find("Radius"), std::string::npos);
    scene_.passes[0].id = "cubist";
    EXPECT_EQ(row("pass/cubist").line.reason, "No picture pass \"cubist\" is known.");
}

TEST_F(EffectRowsTest, EmptyScene_SaysWhatItLacks) {
    for (const char* effect : {"ambient", "fog", "fresnel", "opacity", "emission", "exposure",
                               "tone", "pass", "shadows", "ground", "hemisphere", "occlusion",
                               "environment", "texture", "transparency", "refraction"}) {
        EXPECT_FALSE(row(effect).line.reason.empty()) << effect;
        EXPECT_FALSE(isIn(effect)) << effect;
    }
}

TEST_F(EffectRowsTest, WhatWorksThroughTheModel_IsWithinIt) {
    useEverything();
    for (const char* effect : {"lights/point", "lights/head", "ambient", "hemisphere",
                               "environment/studio", "emission", "specular/gaussian"}) {
        EXPECT_EQ(row(effect).within, "models/lambert") << effect;
    }
    for (const char* effect :
         {"models/lambert", "fog/linear", "opacity", "fresnel/schlick", "ground"}) {
        EXPECT_EQ(row(effect).within, "") << effect;
    }
}

TEST_F(EffectRowsTest, OcclusionWithoutLightFromAllAround_SaysSo) {
    scene_.occlusion = true;
    scene_.lights = {light("head")};
    EXPECT_FALSE(isIn("occlusion"));
    EXPECT_EQ(row("occlusion").line.reason, "The scene has no environment and no ambient light.");
    scene_.ambient = glm::dvec3(0.1);
    EXPECT_TRUE(isIn("occlusion"));
    EXPECT_TRUE(row("occlusion").removable);
    scene_.objects[0].material = material("toon");
    EXPECT_FALSE(isIn("occlusion"));
}

TEST_F(EffectRowsTest, FillingOfASlotThatIsNeverEmpty_CannotBeLeftOut) {
    scene_.objects[0].material = material("cook-torrance");
    const std::string filling = catalog().find("models", "cook-torrance")->slots[0].defaultBlock;
    EXPECT_FALSE(row("fresnel/" + filling).removable);
    EXPECT_EQ(row("fresnel/" + filling).within, "models/cook-torrance");
}

TEST_F(EffectRowsTest, LightsThatShine_AreNamed) {
    scene_.lights = {light("point"), light("point"), light("point")};
    scene_.lights[0].name = "Key";
    scene_.lights[1].name.clear();
    scene_.lights[2].name = "Rim";
    EXPECT_EQ(row("lights/point").line.reason, "Key, light 2 and Rim shine.");
}

TEST_F(EffectRowsTest, LightsThatDoNotShine_SayWhy) {
    scene_.lights = {light("point"), light("point"), light("point")};
    const char* names[] = {"Off", "Black", "Dim"};
    for (std::size_t i = 0; i < 3; ++i) {
        scene_.lights[i].name = names[i];
    }
    scene_.lights[0].enabled = false;
    scene_.lights[1].block.parameters["color"] = glm::dvec3(0.0);
    scene_.lights[2].block.parameters["intensity"] = 0.0;
    EXPECT_EQ(row("Off").line.reason, "It is switched off.");
    EXPECT_EQ(row("Black").line.reason, "It is black.");
    EXPECT_EQ(row("Dim").line.reason, "Its “Intensity” is 0.");
}

TEST_F(EffectRowsTest, ConeWithoutAnyWidth_DoesNotShine) {
    scene_.lights = {light("spot")};
    scene_.lights[0].name = "Spot";
    EXPECT_EQ(row("lights/spot").line.reason, "Spot shines.");
    const std::uint64_t shining = EffectKey().ofScene(scene_, catalog());
    scene_.lights[0].block.parameters["angle.outer"] = 0.0;
    EXPECT_FALSE(isIn("lights/spot"));
    EXPECT_EQ(row("Spot").line.reason, "Its “Outer angle” is 0.");
    EXPECT_NE(EffectKey().ofScene(scene_, catalog()), shining);
}

TEST_F(EffectRowsTest, EqualRoughness_SaysHowMuchItIs) {
    scene_.objects[0].material = material("ward");
    Values& values = scene_.objects[0].material.model.parameters;
    values["roughness.x"] = 0.31;
    values["roughness.y"] = 0.31;
    EXPECT_FALSE(isIn("anisotropy"));
    EXPECT_TRUE(row("anisotropy").line.reason.ends_with(" are both 0.31."))
        << row("anisotropy").line.reason;
    values["roughness.y"] = 0.3;
    EXPECT_TRUE(row("anisotropy").line.effect.empty());
}

TEST_F(EffectRowsTest, Fog_SaysHowMuchItHides) {
    useFog("exponential", "density", 0.02);
    EXPECT_EQ(row("fog/exponential", 14.0).line.reason,
              "Density 0.02: at up to 14 m it hides 24 %.");
}

TEST_F(EffectRowsTest, FogThatNothingIsSeenThrough_IsLeftOut) {
    useFog("box", "density", 5.0);
    EffectView view{10.0};
    EXPECT_TRUE(sceneEffects(scene_, catalog(), view).fog);
    view.missesFog = true;
    EXPECT_FALSE(sceneEffects(scene_, catalog(), view).fog);
    EXPECT_NE(EffectKey().ofScene(scene_, catalog(), view),
              EffectKey().ofScene(scene_, catalog(), {10.0}));
    const std::vector<EffectLine> left =
        leftOut(sceneEffects(scene_, catalog(), view), {nullptr, scene_, catalog(), view});
    const auto fog = std::ranges::find(left, "fog", &EffectLine::effect);
    ASSERT_NE(fog, left.end());
    EXPECT_EQ(fog->reason,
              "Density 5: nothing that is drawn lies in its box or is seen through it.");
}

TEST_F(EffectRowsTest, FogTooThinToBeSeen_IsLeftOut) {
    useFog("exponential", "density", 1e-6);
    EXPECT_FALSE(isIn("fog/exponential"));
    EXPECT_TRUE(row("fog").line.reason.ends_with("it changes no pixel by half of an 8-bit step."))
        << row("fog").line.reason;
}

TEST_F(EffectRowsTest, ThinFog_IsInWhereThingsAreFarEnough) {
    useFog("exponential", "density", 1e-6);
    EXPECT_TRUE(isIn("fog/exponential", 1e4));
}

TEST_F(EffectRowsTest, ThinFog_IsInWhereTheExposureShowsIt) {
    useFog("exponential", "density", 1e-6);
    scene_.exposure = 8.0;
    EXPECT_TRUE(isIn("fog/exponential"));
}

TEST_F(EffectRowsTest, ThinFogAtUnknownDepth_IsIn) {
    useFog("exponential", "density", 1e-6);
    EXPECT_TRUE(isIn("fog/exponential", EffectView().farthest));
}

TEST_F(EffectRowsTest, FogThatBeginsBehindEverything_IsLeftOut) {
    useFog("linear", "start", 20.0);
    scene_.part(kinds::fog)->parameters["end"] = 30.0;
    EXPECT_FALSE(isIn("fog/linear", 15.0));
    EXPECT_TRUE(isIn("fog/linear", 21.0));
}

TEST_F(EffectRowsTest, FogSentence_NamesTheDepthThatThereIs) {
    useFog("exponential", "density", 0.05);
    EXPECT_EQ(row("fog/exponential", 8.4).line.reason,
              "Density 0.05: at up to 8.4 m it hides 34 %.");
}

TEST_F(EffectRowsTest, FogInABoxWithoutAnyWidth_IsLeftOut) {
    useFog("box", "density", 100.0);
    EXPECT_TRUE(isIn("fog/box", 8.4));
    EXPECT_EQ(row("fog/box", 8.4).line.reason.find("1e+02"), std::string::npos);
    Scene clear = scene_;
    clear.setPart(kinds::fog, std::nullopt);
    EffectKey keys;
    for (const glm::dvec3& size : {glm::dvec3(0.0), glm::dvec3(4.0, 0.0, 4.0)}) {
        scene_.part(kinds::fog)->parameters["size"] = size;
        EXPECT_FALSE(isIn("fog/box", 8.4));
        EXPECT_EQ(keys.ofScene(scene_, catalog(), {8.4}), keys.ofScene(clear, catalog(), {8.4}));
    }
}

/// No ray is longer in it than its diagonal.
TEST_F(EffectRowsTest, ThinFogInASmallBox_IsLeftOutAtAnyDepth) {
    useFog("box", "density", 0.01);
    scene_.part(kinds::fog)->parameters["size"] = glm::dvec3(1e-3);
    EXPECT_FALSE(isIn("fog/box", 1000.0));
    scene_.part(kinds::fog)->parameters["size"] = glm::dvec3(10.0);
    EXPECT_TRUE(isIn("fog/box", 1000.0));
}

/// Halves of 8-bit steps, by the worst case that there is: black behind bright fog.
TEST_F(EffectRowsTest, FogThatIsLeftOut_CannotBeSeen) {
    useFog("exponential", "density", 0.0);
    const Block& fog = *catalog().find("fog", "exponential");
    for (double density = 1e-9; density < 1.0; density *= 1.3) {
        scene_.part(kinds::fog)->parameters["density"] = density;
        const double light = *hiddenShare(fog, scene_.part(kinds::fog)->parameters, 10.0) * 0.6;
        const double shown =
            light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
        EXPECT_TRUE(isIn("fog/exponential") || shown < 0.5 / 255.0) << density;
    }
}

TEST_F(EffectRowsTest, Key_TellsFogThatIsSeenFromFogThatIsNot) {
    useFog("exponential", "density", 1e-6);
    EffectKey keys;
    const std::uint64_t near = keys.ofScene(scene_, catalog(), {10.0});
    EXPECT_EQ(keys.ofScene(scene_, catalog(), {11.0}), near);
    EXPECT_NE(keys.ofScene(scene_, catalog(), {1e4}), near);
    scene_.setPart(kinds::fog, std::nullopt);
    EXPECT_EQ(keys.ofScene(scene_, catalog(), {10.0}), near);
}

TEST_F(EffectRowsTest, NeutralOpacityAmbientAndFresnel_AreOut) {
    scene_.objects[0].material.opacity = 1.0;
    scene_.ambient = glm::dvec3(0.0);
    const EffectSet set = effectSet(scene_.objects[0].material, scene_, catalog());
    EXPECT_FALSE(set.opacity);
    EXPECT_FALSE(set.ambient);
    EXPECT_FALSE(set.blend);
}

TEST_F(EffectRowsTest, SwitchedOffEffect_IsNotInTheText) {
    useEverything();
    const std::vector<std::string> off{"fog/linear", "ambient", "hemisphere", "shadows/soft",
                                       "lights/point"};
    const std::string before = fragment(scene_.objects[0].material, scene_);
    const Scene without = withoutEffects(scene_, off, catalog());
    const std::string after = fragment(without.objects[0].material, without);
    for (const char* name : {"linearFog", "ambientShare", "softShadow", "pointLight"}) {
        EXPECT_NE(before.find(name), std::string::npos) << name;
        EXPECT_EQ(after.find(name), std::string::npos) << name;
    }
}

TEST_F(EffectRowsTest, UnknownEffect_ChangesNothing) {
    useEverything();
    const std::vector<std::string> off{"no/such", "nothing"};
    EXPECT_EQ(withoutEffects(scene_, off, catalog()), scene_);
}

TEST_F(EffectRowsTest, UnknownModel_ListsNoLights) {
    scene_.lights = {light("point")};
    scene_.objects[0].material.model.id = "unheard-of";
    EXPECT_FALSE(isIn("lights/point"));
}

} // namespace
} // namespace patina::effect_rows_test
