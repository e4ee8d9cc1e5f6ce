// SPDX-License-Identifier: GPL-3.0-or-later
// The side of a shape that faces away shows nowhere.
#include "gpu_fixture.h"

namespace patina::far_side_test {
namespace {

constexpr std::size_t centre = 4 * (33 * 16 + 16);

int litPixels(const Image& image) {
    int lit = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const auto* color = &image.pixels[i];
        lit += color[0] != 0.0f || color[1] != 0.0f || color[2] != 0.0f ? 1 : 0;
    }
    return lit;
}

class FarSideTest : public GpuTest {
  protected:
    Scene lampInACube() const {
        Scene scene = simpleScene();
        scene.objects[0].mesh = "builtin:cube";
        scene.background = glm::dvec3(0.0);
        scene.lights = {light("point")};
        scene.lights[0].block.parameters["position"] = glm::dvec3(0.0);
        scene.camera.distance = 3.0;
        scene.camera.pitch = 35.0;
        return scene;
    }

    void expectDarkAround(Scene scene) {
        for (const double yaw : {3.0, 30.0, 68.7}) {
            scene.camera.yaw = yaw;
            EXPECT_EQ(litPixels(capture(scene, false, 240)), 0) << yaw;
        }
    }
};

/// Only the inside is lit. Along the outline its depths are nearly those of the outside.
TEST_F(FarSideTest, LampInACube_LightsNoPixelOfItsOutside) {
    makeRenderer();
    expectDarkAround(lampInACube());
}

TEST_F(FarSideTest, LampInACubeThroughALongLens_LightsNoPixelOfItsOutside) {
    makeRenderer();
    Scene scene = lampInACube();
    scene.camera.distance = 100.0;
    scene.camera.fieldOfView = 1.0;
    expectDarkAround(scene);
}

/// A sticker whose triangles are wound the other way, 1 cm before a wall 150 m away.
TEST_F(FarSideTest, CardThatFacesAway_ShowsBeforeTheWallThroughALongLens) {
    makeRenderer();
    Scene scene = plate();
    scene.camera.distance = 150.0;
    scene.camera.fieldOfView = 1.0;
    const double wall = capture(scene).pixels[centre];
    Object card = scene.objects[0];
    card.rotation.x = -90.0;
    card.scale = glm::dvec3(0.5);
    card.translation.z = 0.01;
    card.material.model.parameters["diffuse.color"] = glm::dvec3(0.1);
    scene.objects.push_back(card);
    EXPECT_NEAR(capture(scene).pixels[centre], 0.1 * wall, 1e-3 * wall);
}

} // namespace
} // namespace patina::far_side_test
