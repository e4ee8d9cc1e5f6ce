// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/ground_place.h"

#include <algorithm>
#include <cmath>

#include "gpu_fixture.h"
#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"

namespace patina::ground_test {
namespace {

class GroundTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        scene_ = simpleScene();
        scene_.camera.pitch = 30.0;
        scene_.camera.distance = 8.0;
        scene_.lights = {sun({0.6, -1.0, 0.0})};
        scene_.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
        scene_.ground.mode = GroundMode::Shadows;
    }

    Scene scene_;
};

TEST_F(GroundTest, ThatCatchesShadows_OnlyDarkensTheBackground) {
    const Image with = capture(scene_);
    scene_.ground.mode = GroundMode::Off;
    const Image without = capture(scene_);
    int darker = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        EXPECT_LE(with.pixels[i], without.pixels[i] + 1e-4f);
        darker += with.pixels[i] < without.pixels[i] - 0.1f;
    }
    EXPECT_GT(darker, 30);
}

TEST_F(GroundTest, WithoutShadows_IsNotDrawn) {
    scene_.lights[0].setPart(kinds::shadows, std::nullopt);
    const Image with = capture(scene_);
    scene_.ground.mode = GroundMode::Off;
    EXPECT_EQ(with.pixels, capture(scene_).pixels);
}

TEST_F(GroundTest, Plane_ShowsItsColourTimesTheLight) {
    scene_.ground.mode = GroundMode::Plane;
    scene_.ground.color = {0.5, 0.25, 0.125};
    scene_.lights = {sun({0.0, -1.0, 0.0})};
    scene_.camera.pitch = 60.0;
    const Image image = capture(scene_);
    const glm::vec3 corner = pixel(image, 1, image.height - 2);
    EXPECT_NEAR(corner.r, 0.5f, 2e-3f);
    EXPECT_NEAR(corner.g, 0.25f, 2e-3f);
    EXPECT_NEAR(corner.b, 0.125f, 2e-3f);
}

TEST_F(GroundTest, SeenFromBelow_IsNotThere) {
    scene_.camera.pitch = -30.0;
    const Image with = capture(scene_);
    scene_.ground.mode = GroundMode::Off;
    EXPECT_EQ(with.pixels, capture(scene_).pixels);
}

/// The lamp's range ends before the sphere, which is drawn with another list of lights.
TEST_F(GroundTest, Plane_IsLitByALampThatDoesNotReachTheObjects) {
    scene_.ground.mode = GroundMode::Plane;
    scene_.lights = {light("point")};
    scene_.lights[0].block.parameters["position"] = glm::dvec3(4.0, 0.0, 0.0);
    scene_.lights[0].block.parameters["range"] = 2.5;
    scene_.camera.pivot.x = 4.0;
    const Image with = capture(scene_);
    scene_.lights[0].enabled = false;
    const Image without = capture(scene_);
    EXPECT_GT(middle(with).g, middle(without).g + 0.02f);
}

/// Fog that begins behind the sphere, and before the ground ends.
TEST_F(GroundTest, ReachingIntoFog_BringsTheFogIntoTheProgram) {
    scene_.setPart(kinds::fog, block("fog", "linear"));
    scene_.part(kinds::fog)->parameters["start"] = 40.0;
    scene_.part(kinds::fog)->parameters["end"] = 60.0;
    const auto hasFog = [this] {
        const EffectView view = effectView(scene_, scene_.camera, *catalog, meshSource());
        const bool isInRows = sceneEffects(scene_, *catalog, view).fog.has_value();
        capture(scene_);
        const auto& effects = renderer->report().effects;
        EXPECT_EQ(isInRows, std::ranges::count(effects, "fog/linear") > 0);
        return isInRows;
    };
    EXPECT_FALSE(hasFog());
    scene_.camera.distance = 25.0;
    EXPECT_TRUE(hasFog());
    scene_.ground.mode = GroundMode::Off;
    EXPECT_FALSE(hasFog());
}

/// A turned cube stands on its edge: 1.414 times its half side below its middle.
TEST(LowestPoint, OfATurnedMesh_IsThatOfItsVertices) {
    const Mesh cube = *primitive("cube");
    Object object;
    object.rotation.z = 45.0;
    object.translation.y = 2.0;
    EXPECT_NEAR(lowestPoint(cube.view(), worldMatrix(object)),
                2.0 - std::sqrt(2.0) * double(cube.bounds.upper.y), 1e-6);
}

} // namespace
} // namespace patina::ground_test
