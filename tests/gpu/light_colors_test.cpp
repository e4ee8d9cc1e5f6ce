// SPDX-License-Identifier: GPL-3.0-or-later
// Lights with separate colours, and highlights with an ambient colour of their own.
#include <algorithm>

#include "gpu_fixture.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/effect_rows.h"
#include "shading/effects/surface_program.h"

namespace patina::light_colors_test {
namespace {

const glm::dvec3 black(0.0);
const glm::dvec3 tint(0.25, 0.5, 1.0);

class LightColorsTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        scene_ = simpleScene("phong");
        scene_.background = black;
        scene_.lights.push_back(light("point"));
        model()["diffuse.color"] = glm::dvec3(0.5, 0.25, 0.125);
        model()["specular.color"] = glm::dvec3(0.5);
    }

    Values& model() { return scene_.objects[0].material.model.parameters; }

    void color(const std::string& id, const glm::dvec3& value) {
        for (Light& each : scene_.lights) {
            each.block.parameters[id] = value;
        }
    }

    /// Returns the farthest that two pictures are apart.
    static double apart(const Image& a, const Image& b) {
        double largest = a.pixels.size() == b.pixels.size() ? 0.0 : 1e30;
        for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
            largest = std::max(largest, std::abs(double(a.pixels[i]) - double(b.pixels[i])));
        }
        return largest;
    }

    std::string text() const {
        const EffectSet set = effectSet(scene_.objects[0].material, scene_, *catalog);
        const auto program = surfaceProgram(set, *catalog);
        EXPECT_TRUE(program);
        return program ? program->fragment.text : std::string();
    }

    Scene scene_;
};

TEST_F(LightColorsTest, WhiteAndBlack_AreNotInTheText) {
    for (Light& each : scene_.lights) {
        for (const char* id : {"color.diffuse", "color.highlight", "color.ambient"}) {
            each.block.parameters.erase(id);
        }
    }
    const std::string plain = text();
    const std::uint64_t key = EffectKey().ofScene(scene_, *catalog);
    color("color.diffuse", glm::dvec3(1.0));
    color("color.highlight", glm::dvec3(1.0));
    color("color.ambient", black);
    EXPECT_EQ(text(), plain);
    EXPECT_EQ(EffectKey().ofScene(scene_, *catalog), key);
    for (const char* word : {"highlightAlone", "InColors", "ambientFrom"}) {
        EXPECT_EQ(plain.find(word), std::string::npos) << word;
    }
}

TEST_F(LightColorsTest, OnMattePartsAlone_IsTheModelWithoutItsHighlight) {
    color("color.highlight", black);
    const Image separate = capture(scene_);
    color("color.highlight", glm::dvec3(1.0));
    model()["specular.color"] = black;
    EXPECT_LT(apart(separate, capture(scene_)), 1e-3);
}

TEST_F(LightColorsTest, InHighlightsAlone_IsTheModelWithoutItsDiffuseTerm) {
    color("color.diffuse", black);
    const Image separate = capture(scene_);
    color("color.diffuse", glm::dvec3(1.0));
    model()["diffuse.color"] = black;
    EXPECT_LT(apart(separate, capture(scene_)), 1e-3);
}

TEST_F(LightColorsTest, ThatAreEqual_AreTheLightsColor) {
    color("color.diffuse", tint);
    color("color.highlight", tint);
    const Image separate = capture(scene_);
    color("color.diffuse", glm::dvec3(1.0));
    color("color.highlight", glm::dvec3(1.0));
    color("color", tint);
    EXPECT_LT(apart(separate, capture(scene_)), 1e-3);
}

/// A highlight in the slot of a matte model is a highlight as well.
TEST_F(LightColorsTest, InASlot_AreThoseOfTheHighlight) {
    scene_.objects[0].material.model = block("models", "lambert");
    const Image matte = capture(scene_);
    scene_.objects[0].material.parts["specular"] = block("specular", "phong");
    EXPECT_GT(apart(matte, capture(scene_)), 0.1);
    color("color.highlight", black);
    EXPECT_LT(apart(matte, capture(scene_)), 1e-3);
}

/// A model that is all of one piece counts as diffuse.
TEST_F(LightColorsTest, OfAModelWithoutTerms_AreTheDiffuseOne) {
    scene_.objects[0].material.model = block("models", "strauss");
    color("color.diffuse", tint);
    color("color.highlight", black);
    const Image separate = capture(scene_);
    color("color.diffuse", glm::dvec3(1.0));
    color("color.highlight", glm::dvec3(1.0));
    color("color", tint);
    EXPECT_LT(apart(separate, capture(scene_)), 1e-3);
}

TEST_F(LightColorsTest, AmbientOfALight_IsAmbientLightOfItsColor) {
    scene_.lights.resize(1);
    color("color", {1.0, 0.5, 0.25});
    scene_.lights[0].block.parameters["intensity"] = 2.0;
    color("color.ambient", {0.1, 0.2, 0.4});
    const Image fromLight = capture(scene_);
    color("color.ambient", black);
    EXPECT_GT(apart(fromLight, capture(scene_)), 0.01);
    scene_.ambient = {0.2, 0.2, 0.2};
    EXPECT_LT(apart(fromLight, capture(scene_)), 1e-3);
}

TEST_F(LightColorsTest, AmbientOfHighlights_IsAddedToWhatTheModelMakesOfIt) {
    scene_.lights.clear();
    scene_.objects[0].material.model = block("models", "lambert");
    scene_.objects[0].material.parts["specular"] = block("specular", "phong");
    scene_.ambient = {1.0, 0.5, 0.25};
    const std::string plain = text();
    const glm::vec3 before = middle(capture(scene_));
    Values& highlight = scene_.objects[0].material.parts["specular"].parameters;
    highlight["ambient.color"] = glm::dvec3(0.1, 0.2, 0.4);
    const glm::vec3 after = middle(capture(scene_));
    EXPECT_LT(glm::distance(after - before, glm::vec3(0.1f, 0.1f, 0.1f)), 1e-3f);
    EXPECT_NE(text(), plain);
    highlight["ambient.color"] = black;
    EXPECT_EQ(text(), plain);
}

TEST_F(LightColorsTest, AmbientOfHighlights_HasARowAndASwitch) {
    scene_.objects[0].material.model = block("models", "lambert");
    scene_.objects[0].material.parts["specular"] = block("specular", "phong");
    scene_.objects[0].material.parts["specular"].parameters["ambient.color"] = glm::dvec3(0.5);
    const auto row = [&] {
        for (const EffectRow& each : effectRows(scene_, 0, *catalog)) {
            if (each.line.effect.starts_with("highlight-ambient")) {
                return each;
            }
        }
        return EffectRow();
    };
    EXPECT_FALSE(row().in);
    EXPECT_EQ(row().line.reason, "There is no ambient light.");
    scene_.ambient = glm::dvec3(0.5);
    EXPECT_TRUE(row().in);
    EXPECT_TRUE(row().removable);
    const std::vector<std::string> off{"highlight-ambient"};
    const Scene without = withoutEffects(scene_, off, *catalog);
    EXPECT_EQ(without.objects[0].material.parts.at("specular").parameters.at("ambient.color"),
              Value(black));
}

TEST_F(LightColorsTest, OfAnySize_StayFiniteAndNotNegative) {
    model()["diffuse.color"] = glm::dvec3(1.0);
    scene_.ambient = glm::dvec3(1e6);
    for (const double size : {0.0, 1e-30, 10000.0}) {
        color("color.diffuse", glm::dvec3(size));
        color("color.highlight", glm::dvec3(10000.0 - size));
        color("color.ambient", glm::dvec3(size));
        for (const float value : capture(scene_, false, 9).pixels) {
            ASSERT_TRUE(value >= 0.0f && value <= 65504.0f) << size;
        }
    }
}

} // namespace
} // namespace patina::light_colors_test
