// SPDX-License-Identifier: GPL-3.0-or-later
// Ambient light from a sky and a ground.
#include "gpu_fixture.h"

namespace patina::hemisphere_test {
namespace {

class HemisphereTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        scene_ = simpleScene();
        scene_.lights.clear();
        scene_.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
        scene_.hemisphere = {glm::dvec3(0.8), glm::dvec3(0.2), {0.0, 1.0, 0.0}};
    }

    Scene scene_;
};

TEST_F(HemisphereTest, WhiteSurface_ShowsTheShareOfTheSkyThatItFaces) {
    const Image image = capture(scene_);
    EXPECT_NEAR(middle(image).r, 0.5f, 2e-3f);
    EXPECT_GT(pixel(image, 16, 8).r, 0.6f);
    EXPECT_LT(pixel(image, 16, 24).r, 0.4f);
}

TEST_F(HemisphereTest, Up_TurnsIt) {
    scene_.hemisphere.up = {0.0, 0.0, 7.0}; // towards the camera
    EXPECT_NEAR(middle(capture(scene_)).r, 0.8f, 2e-3f);
}

TEST_F(HemisphereTest, WithoutADirection_UpIsUp) {
    const Image before = capture(scene_);
    scene_.hemisphere.up = glm::dvec3(0.0);
    EXPECT_EQ(capture(scene_), before);
}

TEST_F(HemisphereTest, BesideAmbient_BothAdd) {
    scene_.ambient = glm::dvec3(0.1);
    EXPECT_NEAR(middle(capture(scene_)).r, 0.6f, 2e-3f);
}

} // namespace
} // namespace patina::hemisphere_test
