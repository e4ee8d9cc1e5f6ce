// SPDX-License-Identifier: GPL-3.0-or-later
// Light that passes because a model says so: the same opacity as the material's own.
#include <cmath>

#include "gpu_fixture.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/effect_rows.h"
#include "shading/effects/effect_set.h"

namespace patina::model_transparency_test {
namespace {

constexpr float halfPrecision = 1.0f / 1024.0f;

class ModelTransparencyTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// A matt ball without any highlight that lets so much pass.
    Scene ball(double passed, double behind = 0.25) const {
        Scene scene = simpleScene("strauss");
        Values& values = scene.objects[0].material.model.parameters;
        values["smoothness"] = 0.0;
        values["metalness"] = 0.0;
        values["k"] = 0.0;
        values["transparency"] = passed;
        scene.background = glm::dvec3(behind);
        return scene;
    }

    Image capture(const Scene& scene) {
        auto image = renderer->capture(scene, viewOf(scene), meshSource(), false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    std::string opacityReason(const Scene& scene) const {
        const Material& material = scene.objects[0].material;
        const std::vector<EffectLine> lines =
            effectLines(effectSet(material, scene, *catalog), {&material, scene, *catalog, {}});
        const auto found = std::ranges::find(lines, "opacity", &EffectLine::effect);
        return found == lines.end() ? std::string() : found->reason;
    }

    float middleOf(const Scene& scene) { return middle(capture(scene)).g; }
};

TEST_F(ModelTransparencyTest, WhatPasses_ShowsWhatIsBehind) {
    const float whole = middleOf(ball(0.0, 0.0));
    ASSERT_GT(whole, 0.3f);
    EXPECT_NEAR(middleOf(ball(0.4, 0.0)), 0.6f * whole, halfPrecision);
    EXPECT_NEAR(middleOf(ball(0.4, 0.25)), 0.6f * whole + 0.4f * 0.25f, halfPrecision);
    EXPECT_NEAR(middleOf(ball(1.0, 0.25)), 0.25f, halfPrecision);
}

TEST_F(ModelTransparencyTest, HighlightAndGlow_AreNotTakenTwice) {
    Scene shiny = ball(0.5, 0.0);
    Values& values = shiny.objects[0].material.model.parameters;
    values["smoothness"] = 0.5;
    values["k"] = 1.0;
    const float passing = middleOf(shiny);
    values["transparency"] = 0.0;
    const float solid = middleOf(shiny);
    // F is 0 where the light meets the surface straight.
    EXPECT_NEAR(passing, 0.5f * solid, 2.0f * halfPrecision);
    values["transparency"] = 0.5;
    values["emissive.color"] = glm::dvec3(1.0);
    EXPECT_NEAR(middleOf(shiny), passing + 0.5f, 2.0f * halfPrecision);
}

TEST_F(ModelTransparencyTest, TheMaterialsOpacity_WorksOnTop) {
    Scene scene = ball(0.4);
    scene.objects[0].material.opacity = 0.5;
    const float whole = middleOf(ball(0.0, 0.0));
    EXPECT_NEAR(middleOf(scene), 0.3f * whole + 0.7f * 0.25f, halfPrecision);
}

TEST_F(ModelTransparencyTest, EveryAmount_StaysFinite) {
    for (const double passed : {1e-12, 0.5, 1.0 - 1e-9, 1.0}) {
        Scene scene = ball(passed);
        scene.objects[0].material.model.parameters["k"] = 1.0;
        for (const float value : capture(scene).pixels) {
            ASSERT_TRUE(std::isfinite(value) && value >= 0.0f) << passed;
        }
    }
}

TEST_F(ModelTransparencyTest, EffectSet_NamesIt) {
    const Scene clear = ball(0.4);
    const Scene solid = ball(0.0);
    const EffectSet set = effectSet(clear.objects[0].material, clear, *catalog);
    EXPECT_TRUE(isVisiblyTransparent(set));
    EXPECT_EQ(opacityReason(clear),
              "The material's opacity is 1, and its model transmits 40 % of the light.");
    EXPECT_FALSE(isVisiblyTransparent(effectSet(solid.objects[0].material, solid, *catalog)));
    const Scene whole = ball(1.0);
    EXPECT_EQ(opacityReason(whole),
              "The material's opacity is 1, and its model transmits 100 % of the light.");
    EXPECT_NE(EffectKey::ofMaterial(clear.objects[0].material, *catalog),
              EffectKey::ofMaterial(solid.objects[0].material, *catalog));
    EXPECT_EQ(countTransparent(clear, *catalog), 1);
    const std::array<std::string, 1> opacity{"opacity"};
    const Scene without = withoutEffects(clear, opacity, *catalog);
    EXPECT_EQ(countTransparent(without, *catalog), 0);
}

TEST_F(ModelTransparencyTest, MoreThanHalfOfIt_CastsNoShadow) {
    EXPECT_TRUE(hasCaster(ball(0.5), *catalog));
    EXPECT_FALSE(hasCaster(ball(0.6), *catalog));
    Scene both = ball(0.3);
    both.objects[0].material.opacity = 0.7;
    EXPECT_FALSE(hasCaster(both, *catalog));
    Scene shadowed = ball(0.6);
    shadowed.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    shadowed.ground.mode = GroundMode::Plane;
    capture(shadowed);
    EXPECT_EQ(renderer->report().shadowMaps, 0);
    shadowed.objects[0].material.model.parameters["transparency"] = 0.4;
    capture(shadowed);
    EXPECT_GT(renderer->report().shadowMaps, 0);
}

/// Each shows through the other, whichever comes first in the scene.
TEST_F(ModelTransparencyTest, SuchObjects_AreDrawnFarOnesFirst) {
    Scene scene = ball(0.5, 0.0);
    scene.objects.push_back(scene.objects[0]);
    scene.objects[0].translation = {0.0, 0.0, 0.7};
    scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(1.0, 0.0, 0.0);
    scene.objects[1].material.model.parameters["diffuse.color"] = glm::dvec3(0.0, 1.0, 0.0);
    const Image image = capture(scene);
    EXPECT_NEAR(middle(image).r, 2.0f * middle(image).g, 4.0f * halfPrecision);
    std::swap(scene.objects[0], scene.objects[1]);
    EXPECT_EQ(capture(scene), image);
}

} // namespace
} // namespace patina::model_transparency_test
