// SPDX-License-Identifier: GPL-3.0-or-later
// The side of a shape that faces away shows nowhere.
#include "gpu_fixture.h"

namespace patina {
namespace {

class FarSideTest : public GpuTest {};

/// Only the inside is lit. Along the outline its depths are nearly those of the outside.
TEST_F(FarSideTest, LampInACube_LightsNoPixelOfItsOutside) {
    makeRenderer();
    Scene scene = simpleScene();
    scene.objects[0].mesh = "builtin:cube";
    scene.background = glm::dvec3(0.0);
    scene.lights = {light("point")};
    scene.lights[0].block.parameters["position"] = glm::dvec3(0.0);
    scene.camera.distance = 3.0;
    scene.camera.pitch = 35.0;
    for (const double yaw : {3.0, 30.0, 68.7}) {
        scene.camera.yaw = yaw;
        const Image image = capture(scene, false, 240);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            ASSERT_TRUE(i % 4 == 3 || image.pixels[i] == 0.0f) << yaw << ' ' << i / 4;
        }
    }
}

} // namespace
} // namespace patina
