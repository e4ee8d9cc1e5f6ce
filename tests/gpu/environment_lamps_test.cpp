// SPDX-License-Identifier: GPL-3.0-or-later
// The sun and the lamps of an environment, found and taken out of it as lights.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "environment_fixture.h"
#include "render/frame/frame_job.h"
#include "render/lights/environment_lamps.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"

namespace patina::environment_lamps_test {
namespace {

constexpr glm::ivec2 skySize(256, 128);

/// An even sky with discs of light.
struct Disc {
    glm::dvec3 towards;
    double radius; ///< radians
    double radiance;
};

glm::dvec3 directionAt(int x, int y) {
    const double down = std::numbers::pi * (y + 0.5) / skySize.y;
    const double across = 2.0 * std::numbers::pi * ((x + 0.5) / skySize.x - 0.5);
    return {std::sin(down) * std::sin(across), std::cos(down), -std::sin(down) * std::cos(across)};
}

Image skyWith(const std::vector<Disc>& discs) {
    Image image{skySize.x, skySize.y, 3, {}};
    for (int y = 0; y < skySize.y; ++y) {
        for (int x = 0; x < skySize.x; ++x) {
            double light = 0.5;
            for (const Disc& disc : discs) {
                const double c = glm::dot(directionAt(x, y), glm::normalize(disc.towards));
                light = c > std::cos(disc.radius) ? disc.radiance : light;
            }
            for (const double share : {1.0, 0.9, 0.8}) {
                image.pixels.push_back(static_cast<float>(light * share));
            }
        }
    }
    return image;
}

class EnvironmentLampsTest : public EnvironmentTest {
  protected:
    EnvironmentLamps found(const Scene& scene) {
        settled(scene, 4);
        return environmentLamps(renderer->job().environmentRadiance());
    }

    /// The scene's one square, white and matte, facing a lamp.
    void face(Scene& scene, const glm::dvec3& towards) {
        makeWhite(scene);
        scene.objects[0].scale = glm::dvec3(0.01); // alone in the middle of the picture
        scene.objects[0].rotation = {-glm::degrees(std::asin(towards.y)),
                                     glm::degrees(std::atan2(towards.x, towards.z)), 0.0};
        scene.camera.yaw = glm::degrees(std::atan2(towards.x, towards.z));
        scene.camera.pitch = glm::degrees(std::asin(towards.y));
        scene.camera.distance = 0.01;
    }

    /// The scene with its lamps as lights, as the editor takes them out.
    Scene takenOut(Scene scene, const EnvironmentLamps& lamps) const {
        scene.part(kinds::environment)->parameters["limit"] = lamps.limit;
        for (const EnvironmentLamp& lamp : lamps.lamps) {
            Light light = sun(-lamp.direction);
            const double most = std::max({lamp.radiance.r, lamp.radiance.g, lamp.radiance.b});
            light.block.parameters["color"] = lamp.radiance / most;
            light.block.parameters["intensity"] = most;
            scene.lights.push_back(light);
        }
        return scene;
    }
};

TEST_F(EnvironmentLampsTest, DiscsInASky_AreFoundWhereTheyAreTheStrongestFirst) {
    const std::vector<Disc> discs{{{0.3, 0.8, 0.5}, 0.1, 40.0}, {{-0.7, 0.2, 0.6}, 0.2, 4.0}};
    const EnvironmentLamps lamps = found(surrounded("lambert", skyWith(discs)));
    ASSERT_EQ(lamps.lamps.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_GT(glm::dot(lamps.lamps[i].direction, glm::normalize(discs[i].towards)), 0.9995);
        EXPECT_NEAR(lamps.lamps[i].width, 2.0 * discs[i].radius, 0.1 * 2.0 * discs[i].radius);
        EXPECT_NEAR(lamps.lamps[i].radiance.g / lamps.lamps[i].radiance.r, 0.9, 1e-2);
    }
    EXPECT_GT(lamps.limit, 0.5);
    EXPECT_LT(lamps.limit, 4.0);
}

TEST_F(EnvironmentLampsTest, EvenSky_HasNone) {
    const EnvironmentLamps lamps = found(surrounded("lambert", plain(1.0f, skySize)));
    EXPECT_TRUE(lamps.lamps.empty());
    EXPECT_EQ(lamps.limit, 0.0);
}

TEST_F(EnvironmentLampsTest, BlackSky_HasNone) {
    EXPECT_TRUE(found(surrounded("lambert", plain(0.0f, skySize))).lamps.empty());
}

TEST_F(EnvironmentLampsTest, MoreThanFour_AreFourOrLess) {
    std::vector<Disc> discs;
    for (int i = 0; i < 7; ++i) {
        discs.push_back({{std::sin(0.9 * i), 0.3, std::cos(0.9 * i)}, 0.12, 5.0 + 3.0 * i});
    }
    const EnvironmentLamps lamps = found(surrounded("lambert", skyWith(discs)));
    ASSERT_FALSE(lamps.lamps.empty());
    EXPECT_LE(lamps.lamps.size(), 4U);
    EXPECT_GE(lamps.limit, 10.0); // about the fifth one's
}

TEST_F(EnvironmentLampsTest, SurfaceThatFacesALamp_GetsTheSameLightWhenItIsTakenOut) {
    size_ = 9;
    const Scene studio = inTheStudio("lambert");
    const Scene panorama = surrounded("lambert", skyWith({{{0.3, 0.8, 0.5}, 0.08, 300.0}}));
    for (const Scene& lit : {studio, panorama}) {
        const EnvironmentLamps lamps = found(lit);
        ASSERT_FALSE(lamps.lamps.empty());
        Scene scene = lit;
        face(scene, lamps.lamps.front().direction);
        const glm::vec3 before = middle(settled(scene, 4096));
        const glm::vec3 after = middle(settled(takenOut(scene, lamps), 4096));
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(after[i], before[i], 0.02f * before[i]);
        }
        Scene cut = takenOut(scene, lamps);
        cut.lights.clear();
        EXPECT_LT(middle(settled(cut, 1024)).g, 0.9f * before.g);
    }
}

TEST_F(EnvironmentLampsTest, LimitThatIsDraggedToZero_CutsNothing) {
    const Scene scene = inTheStudio("cook-torrance");
    Scene dragged = scene;
    dragged.part(kinds::environment)->parameters["limit"] = 1.0;
    View view = viewWith(scene, 16);
    view.effects = &dragged;
    const auto held = renderer->capture(scene, view, squares(), false);
    const Image right = settled(scene, 16);
    ASSERT_TRUE(held);
    for (std::size_t i = 0; i < right.pixels.size(); ++i) {
        ASSERT_NEAR(held->pixels[i], right.pixels[i], 1e-3f * right.pixels[i] + 1e-5f);
    }
}

TEST_F(EnvironmentLampsTest, LimitOfZero_IsNotInTheText) {
    Scene scene = inTheStudio("lambert");
    const auto textOf = [&](const Scene& shown) {
        const EffectSet set = effectSet(shown.objects[0].material, shown, *catalog);
        return surfaceProgram(set, *catalog, SurfaceOutput::Picture, 1024)->fragment.text;
    };
    EXPECT_EQ(textOf(scene).find("environmentCut"), std::string::npos);
    scene.part(kinds::environment)->parameters["limit"] = 2.0;
    EXPECT_NE(textOf(scene).find("environmentCut"), std::string::npos);
}

} // namespace
} // namespace patina::environment_lamps_test
