// SPDX-License-Identifier: GPL-3.0-or-later
// Where a surface's own glow stands among what makes its colour: shade, Fresnel, glow, fog.
#include "gpu_fixture.h"
#include "scene/picture_choice_text.h"

namespace patina::emission_test {
namespace {

class EmissionTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// A plate that glows red in the dark under a rim of full strength.
    Scene underRim(const glm::dvec3& rim) const {
        Scene scene = plate();
        scene.objects[0].material.model.parameters["emissive.color"] = red_;
        BlockValues fresnel = block("fresnel", "constant");
        fresnel.parameters["f0"] = glm::dvec3(1.0);
        fresnel.parameters["color"] = rim;
        scene.objects[0].material.parts["fresnel"] = fresnel;
        return scene;
    }

    glm::dvec3 red_{0.75, 0.0, 0.0};
};

constexpr float halfFloat = 1e-3f;

TEST_F(EmissionTest, BlackRimOfFullStrength_LeavesTheGlow) {
    const glm::vec3 seen = middle(capture(underRim(glm::dvec3(0.0))));
    EXPECT_LE(glm::distance(seen, glm::vec3(red_)), halfFloat);
}

TEST_F(EmissionTest, ColouredRim_IsAddedToTheGlow) {
    const glm::vec3 seen = middle(capture(underRim({0.0, 0.5, 0.25})));
    EXPECT_LE(glm::distance(seen, glm::vec3(0.75f, 0.5f, 0.25f)), halfFloat);
}

TEST_F(EmissionTest, LightAtVertices_LeavesTheGlowToThePixel) {
    Scene scene = underRim({0.0, 0.5, 0.25});
    const PictureChoiceText& text = *pictureChoiceText("lighting");
    scene.accuracy.choose(text.choice, *text.level("vertex"));
    const glm::vec3 seen = middle(capture(scene));
    EXPECT_LE(glm::distance(seen, glm::vec3(0.75f, 0.5f, 0.25f)), halfFloat);
}

TEST_F(EmissionTest, DenseFog_HidesTheGlow) {
    Scene scene = underRim(glm::dvec3(0.0));
    scene.setPart(kinds::fog, block("fog", "exponential"));
    scene.part(kinds::fog)->parameters["density"] = 1000.0;
    scene.part(kinds::fog)->parameters["color"] = glm::dvec3(0.0, 0.0, 0.5);
    EXPECT_LE(glm::distance(middle(capture(scene)), glm::vec3(0.0f, 0.0f, 0.5f)), halfFloat);
}

} // namespace
} // namespace patina::emission_test
