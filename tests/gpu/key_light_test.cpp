// SPDX-License-Identifier: GPL-3.0-or-later
// Which light a drawing takes, and that it takes no other.
#include "shading/effects/key_light.h"

#include <array>
#include <cmath>
#include <optional>

#include "gpu_fixture.h"
#include "shading/effects/effect_rows.h"
#include "shading_scene.h"

namespace patina::key_light_test {
namespace {

class KeyLight : public ShadingTest {
  protected:
    KeyLight() {
        scene_.objects.emplace_back();
        scene_.objects[0].material = material("toon");
        scene_.lights = {light("directional"), light("directional"), light("directional")};
        scene_.lights[0].name = "Fill";
        scene_.lights[1].name = "Key";
        scene_.lights[2].name = "Rim";
        setIntensities(0.4, 1.2, 0.9);
    }

    void setIntensities(double first, double second, double third) {
        scene_.lights[0].block.parameters["intensity"] = first;
        scene_.lights[1].block.parameters["intensity"] = second;
        scene_.lights[2].block.parameters["intensity"] = third;
    }

    std::optional<std::size_t> key() const { return keyLight(scene_, catalog()); }

    EffectRow row(const std::string& effect) const {
        for (const EffectRow& each : effectRows(scene_, 0, catalog())) {
            if (each.line.effect == effect) {
                return each;
            }
        }
        return {};
    }

    Scene scene_;
};

TEST_F(KeyLight, Unmarked_IsTheBrightestThatIsOn) {
    EXPECT_EQ(key(), 1u);
    scene_.lights[1].enabled = false;
    EXPECT_EQ(key(), 2u);
    scene_.lights[2].block.parameters["color"] = glm::dvec3(0.1, 0.1, 0.9);
    EXPECT_EQ(key(), 0u) << "blue is dark";
}

TEST_F(KeyLight, OfEquals_IsTheFirst) {
    setIntensities(1.0, 1.0, 1.0);
    EXPECT_EQ(key(), 0u);
}

TEST_F(KeyLight, Marked_IsTheKeyHoweverDark_UnlessItIsOff) {
    scene_.lights[0].isKey = true;
    EXPECT_EQ(key(), 0u);
    scene_.lights[2].isKey = true;
    EXPECT_EQ(key(), 2u) << "the brighter one of two that are marked";
    scene_.lights[0].enabled = false;
    scene_.lights[2].block.parameters["intensity"] = 0.0;
    EXPECT_EQ(key(), 1u);
}

TEST_F(KeyLight, WithoutALightThatShines_IsNone) {
    for (Light& light : scene_.lights) {
        light.enabled = false;
    }
    EXPECT_EQ(key(), std::nullopt);
    scene_.lights.clear();
    EXPECT_EQ(key(), std::nullopt);
}

/// 1 / 2^2 = 0.25 of 1.5 is less than 0.4, and more than nothing of a lamp that looks away.
TEST_F(KeyLight, Lamps_CountAsBrightAsTheyAreInTheMiddleOfTheObjects) {
    setIntensities(0.4, 0.0, 0.0);
    scene_.lights[1] = light("point");
    scene_.lights[1].block.parameters["falloff"] = std::string("inverse-square");
    scene_.lights[1].block.parameters["position"] = glm::dvec3(0.0, 2.0, 0.0);
    scene_.lights[1].block.parameters["intensity"] = 1.5;
    EXPECT_EQ(key(), 0u);
    scene_.objects[0].translation = {0.0, 1.0, 0.0};
    EXPECT_EQ(key(), 1u);
    scene_.lights[1] = light("spot");
    EXPECT_EQ(key(), 1u);
    scene_.lights[1].block.parameters["direction"] = glm::dvec3(0.0, 1.0, 0.0);
    EXPECT_EQ(key(), 0u);
}

TEST_F(KeyLight, Brightness_IsFiniteAtEveryEndOfEveryParameter) {
    for (const Block* block : catalog().ofKind(kinds::lights)) {
        for (const Parameter& parameter : block->parameters) {
            const std::array ends{parameter.min, parameter.max};
            for (const Value& value : infoOf(parameter.type).edgeCases(parameter, ends)) {
                Light tried = light(block->id);
                tried.block.parameters[parameter.id] = value;
                const double brightness = brightnessAt(tried, *block, glm::dvec3(0.0));
                EXPECT_TRUE(std::isfinite(brightness) && brightness >= 0.0)
                    << block->id << ' ' << parameter.id;
            }
        }
    }
}

TEST_F(KeyLight, ADrawing_HasNothingOfOtherLightInItsText) {
    scene_.lights[2] = light("point");
    scene_.ambient = glm::dvec3(0.1);
    scene_.hemisphere.sky = glm::dvec3(0.1);
    scene_.setPart(kinds::environment, block("environment", "studio"));
    const std::string text = fragment(scene_.objects[0].material, scene_);
    EXPECT_NE(text.find("directionalLight"), std::string::npos);
    for (const char* other : {"pointLight", "ambientShare", "environmentData", "for (int i"}) {
        EXPECT_EQ(text.find(other), std::string::npos) << other;
    }
    scene_.drawings = DrawingLights::All;
    const std::string whole = fragment(scene_.objects[0].material, scene_);
    for (const char* other : {"pointLight", "ambientShare", "environmentData"}) {
        EXPECT_NE(whole.find(other), std::string::npos) << other;
    }
}

TEST_F(KeyLight, WithoutLights_ADrawingTakesTheEnvironmentAsOne_AndElseTheAmbientLight) {
    scene_.lights.clear();
    scene_.ambient = glm::dvec3(0.1);
    EXPECT_TRUE(row("ambient").in);
    scene_.setPart(kinds::environment, block("environment", "studio"));
    EXPECT_FALSE(row("ambient").in);
    EXPECT_TRUE(row("environment/studio").in);
    EXPECT_TRUE(row("environment/studio").line.detail.ends_with("as one light"));
}

TEST_F(KeyLight, Rows_SayWhichLightItIsAndWhy) {
    scene_.setPart(kinds::environment, block("environment", "studio"));
    EXPECT_EQ(row("lights/directional").line.detail, "key light only: it is a drawing");
    EXPECT_EQ(row("lights/directional").line.reason,
              "Key shines: it is the brightest in the middle of the objects.");
    scene_.lights[2].isKey = true;
    EXPECT_EQ(row("lights/directional").line.reason, "Rim shines: it is marked as the key light.");
    for (const char* other : {"Fill", "Key", "environment/studio"}) {
        EXPECT_FALSE(row(other).in);
        EXPECT_EQ(row(other).line.reason,
                  "The material is a drawing and takes the key light, Rim, alone.");
    }
    scene_.objects[0].material = material("lambert");
    EXPECT_EQ(row("lights/directional").line.reason, "Fill, Key and Rim shine.");
}

TEST_F(KeyLight, NoShadow_FallsOnADrawing) {
    scene_.ground.mode = GroundMode::Plane;
    scene_.lights[1].setPart(kinds::shadows, block("shadows", "soft"));
    EXPECT_EQ(fragment(scene_.objects[0].material, scene_).find("shadowMaps"), std::string::npos);
    EXPECT_FALSE(row("shadows of Key").in);
    EXPECT_EQ(row("shadows of Key").line.reason,
              "The material is a drawing, whose own tones are its shadows.");
    scene_.drawings = DrawingLights::All;
    EXPECT_NE(fragment(scene_.objects[0].material, scene_).find("shadowMaps"), std::string::npos);
}

class KeyLightFrames : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// Three suns, of which the last is the brightest, and one far brighter that is switched off.
    Scene lit(const std::string& model) const {
        Scene scene = simpleScene(model);
        scene.lights = {sun({1.0, -0.2, -0.5}), sun({0.0, -1.0, -0.1}), sun({-0.5, -0.5, -1.0}),
                        sun({0.0, 1.0, 0.0})};
        scene.lights[0].block.parameters["intensity"] = 0.3;
        scene.lights[1].block.parameters["intensity"] = 0.5;
        scene.lights[3].block.parameters["intensity"] = 9.0;
        scene.lights[3].enabled = false;
        scene.ambient = glm::dvec3(0.05);
        return scene;
    }

    std::vector<std::string> drawings() const {
        std::vector<std::string> ids;
        for (const Block* model : catalog->ofKind(kinds::models)) {
            if (model->lighting == LightsWanted::Key) {
                ids.push_back(model->id);
            }
        }
        return ids;
    }
};

TEST_F(KeyLightFrames, ADrawing_LooksAsUnderItsKeyLightAlone) {
    ASSERT_GE(drawings().size(), 4u);
    for (const std::string& model : drawings()) {
        SCOPED_TRACE(model);
        const Scene scene = lit(model);
        Scene alone = scene;
        alone.lights = {scene.lights[2]};
        alone.ambient = glm::dvec3(0.0);
        EXPECT_EQ(capture(scene).pixels, capture(alone).pixels);
        Scene all = scene;
        all.drawings = DrawingLights::All;
        EXPECT_NE(capture(all).pixels, capture(alone).pixels);
    }
}

TEST_F(KeyLightFrames, BesideOtherMaterials_EachTakesItsOwnLight) {
    Scene both = lit("halftone");
    both.objects.push_back(object("lambert"));
    both.objects[0].translation = {-0.6, 0.0, 0.0};
    both.objects[1].translation = {0.6, 0.0, 0.0};
    both.objects[0].scale = both.objects[1].scale = glm::dvec3(0.5);
    Scene alone = both;
    alone.lights = {both.lights[2]};
    alone.ambient = glm::dvec3(0.0);
    const Image together = capture(both);
    const Image keyed = capture(alone);
    double right = 0.0;
    for (int y = 0; y < together.height; ++y) {
        for (int x = 0; x < together.width; ++x) {
            const bool isDrawing = x < together.width / 2;
            const double apart = glm::distance(pixel(together, x, y), pixel(keyed, x, y));
            EXPECT_TRUE(!isDrawing || apart == 0.0) << x << ' ' << y;
            right += apart;
        }
    }
    EXPECT_GT(right, 1.0);
}

/// The other sun becomes the brighter one, in programs that are there.
TEST_F(KeyLightFrames, AnotherKeyLightOfTheSameKind_CompilesNothing) {
    Scene scene = lit("toon");
    capture(scene);
    scene.lights[1].block.parameters["intensity"] = 3.0;
    const Image brighter = capture(scene);
    EXPECT_EQ(renderer->report().compiled, 0);
    scene.lights = {scene.lights[1]};
    scene.ambient = glm::dvec3(0.0);
    EXPECT_EQ(brighter.pixels, capture(scene).pixels);
}

TEST_F(KeyLightFrames, KeyLightThatEndsBeforeTheObject_LeavesItDark) {
    Scene scene = lit("gooch");
    scene.lights.push_back(light("point"));
    scene.lights.back().isKey = true;
    scene.lights.back().block.parameters["position"] = glm::dvec3(50.0, 0.0, 0.0);
    scene.lights.back().block.parameters["range"] = 1.0;
    EXPECT_EQ(middle(capture(scene)), glm::vec3(0.0f));
}

TEST_F(KeyLightFrames, WithoutAnyLight_IsBlackAndFinite) {
    for (const std::string& model : drawings()) {
        Scene scene = simpleScene(model);
        scene.lights.clear();
        EXPECT_EQ(middle(capture(scene)), glm::vec3(0.0f)) << model;
    }
}

} // namespace
} // namespace patina::key_light_test
