// SPDX-License-Identifier: GPL-3.0-or-later
// Lights that cannot reach an object are not shaded for it.
#include "render/light_lists.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "gpu_fixture.h"
#include "render/unreached_lights.h"

namespace patina {
namespace {

class LightListsTest : public GpuTest {
  protected:
    /// Whether a light is on the list of a ball.
    bool reaches(const Light& light, const Ball& ball) {
        Scene scene;
        scene.lights = {light};
        LightLists lists;
        lists.begin(scene, *catalog);
        return lists.holds(lists.listFor(ball), 0);
    }

    Light lamp(const glm::dvec3& position, double range) const {
        Light made = light("point");
        made.block.parameters["position"] = position;
        made.block.parameters["range"] = range;
        return made;
    }

    /// A spot light at the origin that shines along +x.
    Light spot(double degrees) const {
        Light made = light("spot");
        made.block.parameters["position"] = glm::dvec3(0.0);
        made.block.parameters["direction"] = glm::dvec3(1.0, 0.0, 0.0);
        made.block.parameters["angle.outer"] = degrees;
        return made;
    }

    /// Two spheres side by side, and a lamp whose range ends between them.
    Scene twoSpheres() const {
        Scene scene = simpleScene();
        scene.objects.push_back(object("lambert"));
        scene.objects[0].translation.x = -3.0;
        scene.objects[1].translation.x = 3.0;
        scene.lights.push_back(lamp({-3.0, 0.0, 2.0}, 3.5));
        scene.camera.distance = 14.0;
        return scene;
    }
};

TEST_F(LightListsTest, LampWithoutRange_ReachesEverything) {
    EXPECT_TRUE(reaches(lamp({0, 0, 0}, 0.0), {{1e5, 0, 0}, 1.0}));
}

TEST_F(LightListsTest, Range_EndsAtTheNearestPointOfTheBall) {
    EXPECT_TRUE(reaches(lamp({0, 0, 0}, 2.0), {{2.9, 0, 0}, 1.0}));
    EXPECT_FALSE(reaches(lamp({0, 0, 0}, 2.0), {{3.1, 0, 0}, 1.0}));
}

TEST_F(LightListsTest, Cone_ReachesWhatItTouches) {
    EXPECT_TRUE(reaches(spot(30.0), {{10.0, 6.0, 0.0}, 1.0}));
    EXPECT_FALSE(reaches(spot(30.0), {{10.0, 8.0, 0.0}, 1.0}));
    EXPECT_FALSE(reaches(spot(30.0), {{-3.0, 0.0, 0.0}, 1.0}));
}

TEST_F(LightListsTest, LightInsideTheBall_ReachesIt) {
    EXPECT_TRUE(reaches(spot(1.0), {{-0.5, 0.0, 0.0}, 1.0}));
}

TEST_F(LightListsTest, WideCone_ReachesBehindItself) {
    EXPECT_TRUE(reaches(spot(180.0), {{-30.0, 0.0, 0.0}, 1.0}));
}

TEST_F(LightListsTest, ObjectsWithTheSameLights_ShareAList) {
    Scene scene;
    scene.lights = {lamp({0, 0, 0}, 1.0), lamp({10, 0, 0}, 1.0)};
    LightLists lists;
    lists.begin(scene, *catalog);
    const std::size_t first = lists.listFor({{0, 0, 0}, 0.5});
    EXPECT_EQ(lists.listFor({{0.1, 0, 0}, 0.5}), first);
    EXPECT_NE(lists.listFor({{10, 0, 0}, 0.5}), first);
    EXPECT_EQ(lists.count(), 3u);
}

TEST_F(LightListsTest, MoreListsThanThereMayBe_GetAllLights) {
    Scene scene;
    for (int i = 0; i < 100; ++i) {
        scene.lights.push_back(lamp({10.0 * i, 0, 0}, 1.0));
    }
    LightLists lists;
    lists.begin(scene, *catalog);
    std::size_t last = 0;
    for (int i = 0; i < 100; ++i) {
        last = lists.listFor({{10.0 * i, 0, 0}, 0.5});
    }
    EXPECT_EQ(last, 0u);
    EXPECT_LE(lists.count(), LightLists::most + 1);
}

/// The range of the lamp makes it black there anyway, so the picture does not tell; a lamp whose
/// list is wrong would be missing on the first sphere.
TEST_F(LightListsTest, Picture_IsThatOfEachSphereAlone) {
    makeRenderer();
    const Scene both = twoSpheres();
    Scene first = both;
    first.objects.pop_back();
    Scene second = both;
    second.objects.erase(second.objects.begin());
    const Image all = capture(both, false, 65);
    const Image left = capture(first, false, 65);
    const Image right = capture(second, false, 65);
    for (int y = 0; y < 65; ++y) {
        for (int x = 0; x < 65; ++x) {
            ASSERT_EQ(pixel(all, x, y), pixel(x < 32 ? left : right, x, y)) << x << ' ' << y;
        }
    }
}

TEST_F(LightListsTest, RangedLamp_LightsTheNearSphereOnly) {
    makeRenderer();
    Scene scene = twoSpheres();
    const Image with = capture(scene, false, 65);
    scene.lights.pop_back();
    const Image without = capture(scene, false, 65);
    EXPECT_GT(pixel(with, 14, 32).g, pixel(without, 14, 32).g + 0.05f);
    EXPECT_EQ(pixel(with, 50, 32), pixel(without, 50, 32));
}

/// From the lamp to the middle of the second sphere, less half the diagonal of its box.
TEST_F(LightListsTest, LampThatDoesNotReachAnObject_SaysHowFarThatIs) {
    Scene scene = twoSpheres();
    scene.lights[1].name = "Lamp";
    EXPECT_TRUE(unreachedRows(scene, 0, *catalog, meshSource()).empty());
    const std::vector<EffectRow> rows = unreachedRows(scene, 1, *catalog, meshSource());
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].line.effect, "Lamp");
    EXPECT_FALSE(rows[0].in);
    const double half = glm::length(glm::dvec3(mesh(scene.objects[1]).bounds.upper));
    EXPECT_NE(rows[0].line.reason.find(fmt::format("{:.3g} m", std::sqrt(40.0) - half)),
              std::string::npos)
        << rows[0].line.reason;
    scene.lights[1].enabled = false;
    EXPECT_TRUE(unreachedRows(scene, 1, *catalog, meshSource()).empty());
}

TEST_F(LightListsTest, SecondFrameOfTwoLists_UploadsNothing) {
    makeRenderer();
    const Scene scene = twoSpheres();
    capture(scene);
    capture(scene);
    EXPECT_EQ(renderer->report().uploadedBuffers, 0);
}

TEST_F(LightListsTest, MovingLamp_CompilesNothing) {
    makeRenderer();
    Scene scene = twoSpheres();
    capture(scene);
    int compiled = 0;
    for (const double x : {-3.0, 0.0, 3.0, 30.0}) {
        scene.lights[1].block.parameters["position"] = glm::dvec3(x, 0.0, 2.0);
        capture(scene);
        compiled += renderer->report().compiled;
    }
    EXPECT_EQ(compiled, 0);
}

/// Where the roughnesses meet the program changes, and the picture must not.
class EqualRoughness : public GpuTest, public testing::WithParamInterface<const char*> {};

TEST_P(EqualRoughness, Picture_IsThatOfNearlyEqualOnes) {
    makeRenderer();
    Scene scene = simpleScene(GetParam());
    Values& values = scene.objects[0].material.model.parameters;
    const bool isWard = values.contains("roughness.x");
    const std::string stem = isWard ? "roughness." : "shininess.";
    const double value = isWard ? 0.25 : 50.0;
    values[stem + "x"] = value;
    values[stem + "y"] = value;
    const Image equal = capture(scene);
    values[stem + "y"] = value * (1.0 + 1e-6);
    const Image nearly = capture(scene);
    EXPECT_EQ(renderer->report().compiled, 1);
    for (std::size_t i = 0; i < equal.pixels.size(); ++i) {
        ASSERT_NEAR(equal.pixels[i], nearly.pixels[i], 2e-3 * (1.0 + nearly.pixels[i])) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Models, EqualRoughness, testing::Values("ward", "ashikhmin-shirley"));

} // namespace
} // namespace patina
