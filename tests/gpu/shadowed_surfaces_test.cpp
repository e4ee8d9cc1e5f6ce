// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that shadows must leave lit, and such that they must leave dark: hollows, the insides of
// closed bodies, and places deep in the shade.
#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "gpu_fixture.h"

namespace patina::shadowed_surfaces_test {
namespace {

class ShadowedSurfacesTest : public GpuTest, public testing::WithParamInterface<const char*> {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    BlockValues shadow(const std::string& kind) const { return block("shadows", kind); }

    static float redAt(const Image& image, int x, int y) { return pixel(image, x, y).r; }

    /// Two sheets of one metre by two that rise from the middle by these degrees, shaded as one.
    static Mesh valley(double degrees) {
        Mesh made;
        const auto rise = static_cast<float>(std::tan(glm::radians(degrees)));
        for (const float x : {-1.0f, 0.0f, 1.0f}) {
            for (const float z : {1.0f, -1.0f}) {
                Vertex vertex;
                vertex.position = {x, std::abs(x) * rise, z};
                vertex.normal = glm::normalize(glm::vec3(-x * rise, 1.0f, 0.0f));
                vertex.tangent = {1.0f, 0.0f, 0.0f, 1.0f};
                made.vertices.push_back(vertex);
            }
        }
        made.indices = {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5};
        made.bounds = boundsOf(made.vertices);
        return made;
    }

    /// Pixels of a valley, seen from above, that the shadow darkens by more than a hundredth.
    int darkenedInValley(double degrees, const glm::dvec3& way) {
        meshes["valley"] = valley(degrees);
        Scene scene = simpleScene();
        scene.objects[0].mesh = "builtin:valley";
        scene.camera.pitch = 70.0;
        scene.camera.distance = 4.0;
        scene.lights = {sun(way)};
        const Image open = capture(scene, false, 200);
        scene.lights[0].setPart(kinds::shadows, shadow(GetParam()));
        const Image shaded = capture(scene, false, 200);
        int darkened = 0;
        for (std::size_t i = 0; i < open.pixels.size(); ++i) {
            darkened += shaded.pixels[i] < open.pixels[i] - 0.01f;
        }
        meshes.erase("valley");
        return darkened;
    }

    /// The shader ball in a sun that leaves much of its groove and foot in the shade.
    Scene shadedBall() const {
        Scene scene = simpleScene();
        scene.objects[0].mesh = "builtin:shaderball";
        scene.camera.yaw = 15.0;
        scene.camera.pitch = 15.0;
        scene.camera.distance = 3.9;
        scene.camera.pivot = {0.0, -0.08, 0.0};
        scene.background = glm::dvec3(0.0);
        scene.lights = {sun({0.5, -1.0, -0.3})};
        return scene;
    }
};

TEST_P(ShadowedSurfacesTest, LitHollow_StaysLit) {
    for (const double degrees : {5.0, 10.0, 15.0}) {
        EXPECT_EQ(darkenedInValley(degrees, {0.0, -1.0, 0.0}), 0) << degrees;
        EXPECT_EQ(darkenedInValley(degrees, {0.5, -1.0, 0.4}), 0) << degrees;
    }
}

/// Places that the hard shadow keeps dark for farther around than an edge is wide.
TEST_P(ShadowedSurfacesTest, DeepShade_StaysDark) {
    constexpr int size = 400;
    constexpr int around = 14;
    Scene scene = shadedBall();
    scene.lights[0].setPart(kinds::shadows, shadow("hard"));
    const Image hard = capture(scene, false, size);
    scene.lights[0].setPart(kinds::shadows, shadow(GetParam()));
    const Image tested = capture(scene, false, size);
    int lit = 0;
    int deep = 0;
    for (int y = around; y < size - around; ++y) {
        for (int x = around; x < size - around; ++x) {
            float brightest = 0.0f;
            for (int v = y - around; v <= y + around; ++v) {
                for (int u = x - around; u <= x + around; ++u) {
                    brightest = std::max(brightest, redAt(hard, u, v));
                }
            }
            deep += brightest <= 0.0f;
            lit += brightest <= 0.0f && redAt(tested, x, y) > 0.0f;
        }
    }
    EXPECT_GT(deep, 10000);
    EXPECT_LE(lit, 5) << "a shadow's edge on a surface that the light grazes may be wider";
}

/// A camera in a large cube with a sun outside: no line of light along its edges, of which some 900
/// pixels are in view. A texel is half a pixel here.
TEST_P(ShadowedSurfacesTest, InsideOfAClosedCube_IsDark) {
    constexpr int size = 500;
    Scene scene = simpleScene();
    scene.objects[0].mesh = "builtin:cube";
    scene.objects[0].scale = glm::dvec3(8.0);
    scene.camera.yaw = 10.0;
    scene.camera.pitch = 10.0;
    scene.camera.distance = 3.9;
    scene.camera.fieldOfView = 90.0;
    scene.lights = {sun({0.3, -0.5, -1.0})};
    scene.lights[0].setPart(kinds::shadows, shadow(GetParam()));
    const Image image = capture(scene, false, size);
    int lit = 0;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            lit += redAt(image, x, y) > 0.02f;
        }
    }
    EXPECT_LE(lit, 90);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ShadowedSurfacesTest, testing::Values("hard", "filtered", "soft"),
                         [](const auto& tested) { return std::string(tested.param); });

class FilteredWidth : public ShadowedSurfacesTest {
  protected:
    Image withWidth(double width, double scale) {
        Scene scene = shadedBall();
        scene.objects[0].scale = glm::dvec3(scale);
        scene.camera.distance *= scale;
        scene.camera.pivot *= scale;
        scene.lights[0].setPart(kinds::shadows, shadow("filtered"));
        scene.lights[0].part(kinds::shadows)->parameters["width"] = width;
        return capture(scene, false, 200);
    }
};

TEST_F(FilteredWidth, AboveASixteenthOfWhatCasts_IsThatSixteenth) {
    const Bounds box = primitive("shaderball")->bounds;
    const glm::vec3 sides = box.upper - box.lower;
    const double longest = std::max({sides.x, sides.y, sides.z});
    for (const double scale : {1.0, 0.01}) {
        const Image wide = withWidth(longest * scale, scale);
        const Image widest = withWidth(longest * scale / 16.0, scale);
        const Image narrower = withWidth(longest * scale / 32.0, scale);
        EXPECT_EQ(wide.pixels, widest.pixels) << scale;
        EXPECT_NE(wide.pixels, narrower.pixels) << scale;
    }
}

} // namespace
} // namespace patina::shadowed_surfaces_test
