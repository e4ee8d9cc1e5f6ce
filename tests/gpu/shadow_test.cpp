// SPDX-License-Identifier: GPL-3.0-or-later
// Shadows fall where geometry says: a level square over a level floor, seen from above.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gpu_fixture.h"
#include "render/lights/ground_place.h"

namespace patina::shadow_test {
namespace {

constexpr int pixels = 256;
constexpr double viewAngle = 12.0; // degrees

class ShadowTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        meshes["level"] = groundMesh();
    }

    Light shadowed(Light light, const std::string& kind) const {
        light.setPart(kinds::shadows, block("shadows", kind));
        return light;
    }

    Object level(double height, double side, bool casts) const {
        Object made = object("lambert", "level");
        made.translation.y = height;
        made.scale = glm::dvec3(0.5 * side, 1.0, 0.5 * side);
        made.castsShadow = casts;
        return made;
    }

    /// A square of one metre over a floor; the camera looks down at `middle`.
    Scene squareOverFloor(double height, const Light& light, double middle) const {
        Scene scene;
        scene.objects = {level(height, 1.0, true), level(0.0, 100.0, false)};
        scene.lights = {light};
        scene.camera.pivot = {middle, 0.0, 0.0};
        scene.camera.yaw = 0.0;
        scene.camera.pitch = 90.0;
        scene.camera.distance = 8.0;
        scene.camera.fieldOfView = viewAngle;
        return scene;
    }

    static double floorPixel(const Scene& scene) {
        return 2.0 * scene.camera.distance * std::tan(glm::radians(0.5 * viewAngle)) / pixels;
    }

    /// The floor under a pixel's middle: x to the right, -z up.
    static glm::dvec2 floorAt(const Scene& scene, int x, int y) {
        const double step = floorPixel(scene);
        return {scene.camera.pivot.x + (x + 0.5 - 0.5 * pixels) * step,
                (y + 0.5 - 0.5 * pixels) * step};
    }

    /// Red with shadows over red without.
    std::vector<float> litShares(const Scene& scene) {
        Scene open = scene;
        for (Light& light : open.lights) {
            light.setPart(kinds::shadows, std::nullopt);
        }
        const Image with = capture(scene, false, pixels);
        const Image without = capture(open, false, pixels);
        std::vector<float> shares;
        for (int y = 0; y < pixels; ++y) {
            for (int x = 0; x < pixels; ++x) {
                const float all = pixel(without, x, y).r;
                shares.push_back(all > 0.0f ? pixel(with, x, y).r / all : 1.0f);
            }
        }
        return shares;
    }

    /// Pixels farther than `doubt` from the edge that are not as dark or lit as they must be.
    /// `inside` gives the metres by which a point lies in the shadow.
    template <class Inside>
    int wrongPixels(const Scene& scene, double doubt, Inside inside) {
        const std::vector<float> shares = litShares(scene);
        int wrong = 0;
        int dark = 0;
        for (int y = 0; y < pixels; ++y) {
            for (int x = 0; x < pixels; ++x) {
                const double depth = inside(floorAt(scene, x, y));
                const float share = shares[std::size_t(y * pixels + x)];
                dark += depth > 0.0;
                wrong += (depth > doubt && share > 0.01f) || (depth < -doubt && share < 0.99f);
            }
        }
        EXPECT_GT(dark, 1000) << "no shadow in view";
        EXPECT_LT(dark, pixels * pixels - 1000) << "nothing but shadow in view";
        return wrong;
    }

    /// Returns how far inside the shadow of the square the place lies, in metres on the floor.
    static double insideOf(glm::dvec2 place, const glm::dvec3& light, double height) {
        const glm::dvec3 x(place.x, 0.0, place.y);
        const double share = height / light.y;
        const glm::dvec3 met = x + share * (light - x);
        return (0.5 - std::max(std::abs(met.x), std::abs(met.z))) / (1.0 - share);
    }
};

TEST_F(ShadowTest, OfADirectionalLight_EndsWithinATexel) {
    const Scene scene = squareOverFloor(1.5, shadowed(sun({1.0, -1.0, 0.0}), "hard"), 1.5);
    // The map's window is at most 6 % wider than the square's diagonal of its box in light space.
    const double texel = 1.06 * std::sqrt(2.0) / 2043.0 * std::sqrt(2.0);
    EXPECT_EQ(wrongPixels(scene, texel + floorPixel(scene),
                          [](glm::dvec2 place) {
                              return 0.5 - std::max(std::abs(place.x - 1.5), std::abs(place.y));
                          }),
              0);
}

TEST_F(ShadowTest, OfAPointLight_EndsWithinATexel) {
    Light lamp = shadowed(light("point"), "hard");
    const glm::dvec3 place(-2.0, 4.0, 0.0);
    lamp.block.parameters["position"] = place;
    const Scene scene = squareOverFloor(1.5, lamp, 1.2);
    const double texel = 2.0 / 2048.0 * 5.2 * 1.6; // at the floor, seen at its angle
    EXPECT_EQ(wrongPixels(scene, texel + floorPixel(scene),
                          [&](glm::dvec2 x) { return insideOf(x, place, 1.5); }),
              0);
}

TEST_F(ShadowTest, OfASpotLight_EndsWithinATexel) {
    Light lamp = shadowed(light("spot"), "hard");
    const glm::dvec3 place(-2.0, 4.0, 0.0);
    lamp.block.parameters["position"] = place;
    lamp.block.parameters["direction"] = glm::dvec3(3.0, -4.0, 0.0);
    lamp.block.parameters["angle.inner"] = 60.0;
    lamp.block.parameters["angle.outer"] = 60.0;
    const Scene scene = squareOverFloor(1.5, lamp, 1.2);
    const double texel = 0.6 / 2043.0 * 5.2 * 1.6;
    EXPECT_EQ(wrongPixels(scene, texel + floorPixel(scene),
                          [&](glm::dvec2 x) { return insideOf(x, place, 1.5); }),
              0);
}

TEST_F(ShadowTest, OfASpotOf170Degrees_EndsWithinATexel) {
    Light lamp = shadowed(light("spot"), "hard");
    const glm::dvec3 place(-2.0, 4.0, 0.0);
    lamp.block.parameters["position"] = place;
    lamp.block.parameters["direction"] = glm::dvec3(1.0, 1.0, 0.0);
    lamp.block.parameters["angle.inner"] = 170.0;
    lamp.block.parameters["angle.outer"] = 170.0;
    const Scene scene = squareOverFloor(1.5, lamp, 1.2);
    const double texel = 2.0 / 2048.0 * 5.2 * 1.6;
    EXPECT_EQ(wrongPixels(scene, texel + floorPixel(scene),
                          [&](glm::dvec2 x) { return insideOf(x, place, 1.5); }),
              0);
}

/// A light that is black beyond its range casts shadows at the same places within.
TEST_F(ShadowTest, OfALampWithARange_EndsWithinATexel) {
    Light lamp = shadowed(light("point"), "hard");
    const glm::dvec3 place(-2.0, 4.0, 0.0);
    lamp.block.parameters["position"] = place;
    lamp.block.parameters["range"] = 9.0;
    const Scene scene = squareOverFloor(1.5, lamp, 1.2);
    const double texel = 2.0 / 2048.0 * 5.2 * 1.6;
    EXPECT_EQ(wrongPixels(scene, texel + floorPixel(scene),
                          [&](glm::dvec2 x) { return insideOf(x, place, 1.5); }),
              0);
}

/// The first lamp reaches neither square nor floor: the second keeps the map that is its own.
TEST_F(ShadowTest, BehindALampThatReachesNothing_IsThatOfItsOwnMap) {
    Light lamp = shadowed(light("point"), "hard");
    const glm::dvec3 place(-2.0, 4.0, 0.0);
    lamp.block.parameters["position"] = place;
    lamp.block.parameters["range"] = 9.0;
    Light far = lamp;
    far.block.parameters["position"] = glm::dvec3(3.0, 80.0, 0.0);
    far.block.parameters["range"] = 1.0;
    Scene scene = squareOverFloor(1.5, lamp, 1.2);
    scene.lights.insert(scene.lights.begin(), far);
    const double texel = 2.0 / 2048.0 * 5.2 * 1.6;
    EXPECT_EQ(wrongPixels(scene, texel + floorPixel(scene),
                          [&](glm::dvec2 x) { return insideOf(x, place, 1.5); }),
              0);
}

/// Where a uniform disk that a straight edge uncovers is seen by this share, in radii.
double placeOfShare(double share) {
    double low = -1.0;
    double high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double u = 0.5 * (low + high);
        const double seen = (std::acos(-u) + u * std::sqrt(1.0 - u * u)) / std::numbers::pi;
        (seen < share ? low : high) = u;
    }
    return low;
}

class SoftEdge : public ShadowTest {
  protected:
    /// Metres on the floor between a tenth and nine tenths of the light, over the middle rows.
    double widthAt(double height) {
        Light light = shadowed(sun({1.0, -1.0, 0.0}), "soft");
        light.part(kinds::shadows)->parameters["angle"] = 6.0;
        light.part(kinds::shadows)->parameters["samples"] = std::string("fine");
        Scene scene = squareOverFloor(height, light, height + 0.5);
        scene.objects[0].scale *= 1.0;
        const std::vector<float> shares = litShares(scene);
        std::vector<double> profile(pixels, 0.0);
        constexpr int rows = 40;
        for (int x = 0; x < pixels; ++x) {
            for (int y = (pixels - rows) / 2; y < (pixels + rows) / 2; ++y) {
                profile[std::size_t(x)] += shares[std::size_t(y * pixels + x)] / double(rows);
            }
        }
        return (crossing(profile, 0.9) - crossing(profile, 0.1)) * floorPixel(scene);
    }

    static double crossing(const std::vector<double>& profile, double share) {
        for (std::size_t x = 1; x < profile.size(); ++x) {
            if (profile[x - 1] < share && profile[x] >= share) {
                return double(x) + (share - profile[x]) / (profile[x] - profile[x - 1]);
            }
        }
        ADD_FAILURE() << "the share " << share << " is never reached";
        return 0.0;
    }
};

/// Within 8 % of theory: the mean distance of the blockers is a mean over few places, and the map's
/// own texels add to narrow edges.
TEST_F(SoftEdge, Width_GrowsInProportionToTheDistanceOfWhatCasts) {
    const double tenths = placeOfShare(0.9) - placeOfShare(0.1);
    for (const double height : {0.4, 0.8, 1.2, 1.6, 2.0}) {
        const double radius = std::tan(glm::radians(3.0)) * height * std::sqrt(2.0);
        const double expected = tenths * radius * std::sqrt(2.0); // across the slanted light
        EXPECT_NEAR(widthAt(height) / expected, 1.0, 0.08) << height;
    }
}

class UnshadedSurface : public ShadowTest, public testing::WithParamInterface<const char*> {
  protected:
    static std::vector<glm::dvec3> lightWays() {
        std::vector<glm::dvec3> ways;
        for (const double height : {3.0, 10.0, 25.0, 45.0, 70.0, 89.0}) {
            for (const double turn : {0.0, 37.0, 90.0, 151.0, 200.0, 305.0}) {
                const double up = glm::radians(height);
                const double around = glm::radians(turn);
                ways.emplace_back(std::cos(up) * std::cos(around), -std::sin(up),
                                  std::cos(up) * std::sin(around));
            }
        }
        return ways;
    }

    /// Pixels that the light's shadows make darker by more than a thousandth of white.
    int darkenedBy(const Light& light, const std::string& mesh, int size) {
        Scene scene = simpleScene();
        scene.objects[0].mesh = "builtin:" + mesh;
        scene.camera.pitch = 35.0;
        scene.camera.distance = 3.0;
        scene.lights = {shadowed(light, GetParam())};
        const Image with = capture(scene, false, size);
        scene.lights[0].setPart(kinds::shadows, std::nullopt);
        const Image without = capture(scene, false, size);
        int wrong = 0;
        for (std::size_t i = 0; i < with.pixels.size(); ++i) {
            wrong += with.pixels[i] < without.pixels[i] - 1e-3f;
        }
        return wrong;
    }

    /// Over all ways of a sun.
    int darkened(const std::string& mesh) {
        int wrong = 0;
        for (const glm::dvec3& way : lightWays()) {
            wrong += darkenedBy(sun(way), mesh, 96);
        }
        return wrong;
    }

    /// Lights in the middle, at the edges and in the corners of the six faces of their maps.
    int darkenedFromNearby(const std::string& mesh) {
        int wrong = 0;
        for (const glm::dvec3& place :
             {glm::dvec3(2.0, 3.0, 2.0), glm::dvec3(1.5, 2.0, 1.5), glm::dvec3(1.5, 1.5, 1.5),
              glm::dvec3(2.0, 0.0, 0.0), glm::dvec3(0.0, 2.5, 2.5), glm::dvec3(-4.0, 1.0, 3.0)}) {
            Light lamp = light("point");
            lamp.block.parameters["position"] = place;
            wrong += darkenedBy(lamp, mesh, 240);
        }
        return wrong;
    }
};

TEST_P(UnshadedSurface, Sphere_DoesNotShadeItself) {
    EXPECT_EQ(darkened("sphere"), 0);
}

TEST_P(UnshadedSurface, Plane_DoesNotShadeItself) {
    EXPECT_EQ(darkened("plane"), 0);
}

TEST_P(UnshadedSurface, Cube_DoesNotShadeItself) {
    EXPECT_EQ(darkened("cube"), 0);
}

TEST_P(UnshadedSurface, SphereByALamp_DoesNotShadeItself) {
    EXPECT_EQ(darkenedFromNearby("sphere"), 0);
}

TEST_P(UnshadedSurface, FlatSidesByALamp_DoNotShadeThemselves) {
    EXPECT_EQ(darkenedFromNearby("plane"), 0);
    EXPECT_EQ(darkenedFromNearby("cube"), 0);
}

INSTANTIATE_TEST_SUITE_P(Kinds, UnshadedSurface, testing::Values("hard", "filtered", "soft"),
                         [](const auto& tested) { return std::string(tested.param); });

class ShadowMapsDrawn : public ShadowTest {
  protected:
    void SetUp() override {
        ShadowTest::SetUp();
        scene_ = simpleScene("phong");
        scene_.lights = {shadowed(sun({1.0, -1.0, -1.0}), "hard")};
    }

    int ofTheNextFrame() {
        capture(scene_);
        return renderer->report().shadowMaps;
    }

    Scene scene_;
};

TEST_F(ShadowMapsDrawn, FirstFrame_DrawsOne) {
    EXPECT_EQ(ofTheNextFrame(), 1);
}

TEST_F(ShadowMapsDrawn, LightThatShinesEverywhere_DrawsSix) {
    scene_.lights = {shadowed(light("point"), "hard")};
    EXPECT_EQ(ofTheNextFrame(), 6);
}

TEST_F(ShadowMapsDrawn, SameFrameAgain_DrawsNone) {
    ofTheNextFrame();
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(ShadowMapsDrawn, MaterialValue_DrawsNone) {
    ofTheNextFrame();
    scene_.objects[0].material.model.parameters["shininess"] = 7.0;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(ShadowMapsDrawn, MovedCamera_DrawsNone) {
    ofTheNextFrame();
    scene_.camera.yaw = 50.0;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(ShadowMapsDrawn, LightsColour_DrawsNone) {
    ofTheNextFrame();
    scene_.lights[0].block.parameters["intensity"] = 3.0;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(ShadowMapsDrawn, TurnedLight_DrawsOne) {
    ofTheNextFrame();
    scene_.lights[0].block.parameters["direction"] = glm::dvec3(-1.0, -1.0, 0.0);
    EXPECT_EQ(ofTheNextFrame(), 1);
}

TEST_F(ShadowMapsDrawn, OneOfTwoLightsTurned_DrawsOne) {
    scene_.lights.push_back(shadowed(sun({0.0, -1.0, 0.3}), "hard"));
    EXPECT_EQ(ofTheNextFrame(), 2);
    scene_.lights[0].block.parameters["direction"] = glm::dvec3(-1.0, -1.0, 0.0);
    EXPECT_EQ(ofTheNextFrame(), 1);
}

TEST_F(ShadowMapsDrawn, MovedObject_DrawsOne) {
    ofTheNextFrame();
    scene_.objects[0].translation.x = 0.25;
    EXPECT_EQ(ofTheNextFrame(), 1);
}

TEST_F(ShadowMapsDrawn, WithoutCaster_DrawsNone) {
    scene_.objects[0].castsShadow = false;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

} // namespace
} // namespace patina::shadow_test
