// SPDX-License-Identifier: GPL-3.0-or-later
// Lights that cannot reach an object are not shaded for it.
#include "render/lights/light_lists.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "gpu_fixture.h"
#include "render/lights/light_kinds.h"
#include "render/surfaces/object_rows.h"
#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

namespace patina::light_lists_test {
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

    std::optional<EffectRow> row(const Scene& scene, std::size_t object,
                                 const std::string& effect) {
        for (const EffectRow& each : objectRows(scene, object, *catalog, meshSource())) {
            if (each.line.effect == effect) {
                return each;
            }
        }
        return std::nullopt;
    }

    static LightSet lightSet(std::initializer_list<std::size_t> lights) {
        LightSet set;
        for (const std::size_t each : lights) {
            set.add(each);
        }
        return set;
    }

    bool isInTheFrame(const std::string& effect) const {
        return std::ranges::count(renderer->report().effects, effect) > 0;
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

TEST_F(LightListsTest, HiddenObject_HasNothingIn) {
    Scene scene = twoSpheres();
    scene.objects[0].visible = false;
    scene.objects[1].material.opacity = 0.0;
    for (const std::size_t object : {0u, 1u}) {
        const auto model = row(scene, object, "models/lambert");
        ASSERT_TRUE(model);
        EXPECT_FALSE(model->in) << object;
        EXPECT_FALSE(model->removable) << object;
    }
}

TEST_F(LightListsTest, GroundUnderALampThatMissesTheObject_IsIn) {
    Scene scene = twoSpheres();
    scene.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    scene.ground.mode = GroundMode::Shadows;
    for (const std::size_t object : {0u, 1u}) {
        const auto ground = row(scene, object, "ground");
        ASSERT_TRUE(ground);
        EXPECT_TRUE(ground->in) << object << ": " << ground->line.reason;
    }
}

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
    EXPECT_LE(lists.count(), LightLists::maxCount + 1);
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

/// From the lamp to the nearest edge of the second sphere's box.
TEST_F(LightListsTest, LampThatDoesNotReachAnObject_SaysHowFarThatIs) {
    Scene scene = twoSpheres();
    scene.lights[1].name = "Lamp";
    EXPECT_FALSE(row(scene, 0, "Lamp"));
    const std::optional<EffectRow> lamp = row(scene, 1, "Lamp");
    ASSERT_TRUE(lamp);
    EXPECT_FALSE(lamp->in);
    EXPECT_EQ(lamp->line.reason,
              fmt::format("Its range of 3.5 m ends before this object, which is at least {:.3g} m "
                          "away.",
                          std::sqrt(26.0)));
    scene.lights[1].enabled = false;
    EXPECT_EQ(row(scene, 1, "Lamp")->line.reason, "It is switched off.");
}

/// A thin stick along z, turned: the ball around it would begin 3 m nearer.
TEST_F(LightListsTest, DistanceOfATurnedObject_IsThatOfItsBox) {
    Scene scene = twoSpheres();
    scene.objects[0].mesh = "builtin:cube";
    scene.objects[0].translation = {10.0, 0.0, 0.0};
    scene.objects[0].scale = {0.5, 0.5, 4.0};
    const double side = 0.5 * double(mesh(scene.objects[0]).bounds.upper.x);
    scene.lights = {lamp({0.0, 0.0, 0.0}, 2.0)};
    scene.lights[0].name = "Lamp";
    EXPECT_NE(row(scene, 0, "Lamp")->line.reason.find(fmt::format("{:.3g} m away", 10.0 - side)),
              std::string::npos)
        << row(scene, 0, "Lamp")->line.reason;
    scene.objects[0].rotation = {0.0, 0.0, 45.0};
    EXPECT_NE(row(scene, 0, "Lamp")
                  ->line.reason.find(fmt::format("{:.3g} m away", 10.0 - std::sqrt(2.0) * side)),
              std::string::npos)
        << row(scene, 0, "Lamp")->line.reason;
}

TEST_F(LightListsTest, ConeThatMissesAnObject_SaysSo) {
    Scene scene = simpleScene();
    scene.lights = {spot(10.0)};
    scene.lights[0].name = "Spot";
    scene.objects[0].translation = {0.0, 10.0, 0.0};
    EXPECT_EQ(row(scene, 0, "Spot")->line.reason, "Its cone misses this object.");
}

TEST_F(LightListsTest, LampThatDoesNotReachAnObject_IsNotNamedAmongThoseThatShine) {
    Scene scene = twoSpheres();
    scene.lights[1].name = "Lamp";
    EXPECT_EQ(row(scene, 0, "lights/point")->line.reason, "Lamp shines.");
    EXPECT_FALSE(row(scene, 1, "lights/point"));
    scene.lights.push_back(lamp({3.0, 0.0, 2.0}, 3.5));
    scene.lights[2].name = "Other";
    EXPECT_EQ(row(scene, 0, "lights/point")->line.reason, "Lamp shines.");
    EXPECT_EQ(row(scene, 1, "lights/point")->line.reason, "Other shines.");
}

TEST_F(LightListsTest, KindThatDoesNotReachAnObject_IsNotInItsProgram) {
    const Scene scene = twoSpheres();
    for (const std::size_t object : {0u, 1u}) {
        const EffectView view = objectView(scene, object, *catalog, meshSource());
        const auto source = surfaceProgram(
            effectSet(scene.objects[object].material, scene, *catalog, view), *catalog);
        ASSERT_TRUE(source);
        EXPECT_EQ(source->fragment.text.find("pointLight(") != std::string::npos, object == 0u);
    }
}

TEST_F(LightListsTest, LampThatReachesOneSphere_MakesTwoPrograms) {
    makeRenderer();
    Scene scene = twoSpheres();
    capture(scene);
    EXPECT_EQ(renderer->report().programs, 2);
    EXPECT_TRUE(isInTheFrame("lights/point"));
    scene.lights[1].block.parameters["range"] = 0.0; // without end
    capture(scene);
    EXPECT_EQ(renderer->report().programs, 1);
}

TEST_F(LightListsTest, LampThatReachesNothing_IsInNoProgram) {
    makeRenderer();
    Scene scene = twoSpheres();
    scene.lights[1].block.parameters["position"] = glm::dvec3(0.0, 50.0, 0.0);
    const Image with = capture(scene);
    EXPECT_FALSE(isInTheFrame("lights/point"));
    scene.lights.pop_back();
    EXPECT_EQ(capture(scene).pixels, with.pixels);
}

/// While it is dragged the program has it, wherever it is.
TEST_F(LightListsTest, HeldLamp_IsInAllPrograms) {
    makeRenderer();
    Scene scene = twoSpheres();
    const Scene held = scene;
    View view = viewOf(scene);
    view.effects = &held;
    ASSERT_TRUE(renderer->capture(scene, view, meshSource(), false));
    EXPECT_EQ(renderer->report().programs, 1);
    for (const double x : {0.0, 30.0}) {
        scene.lights[1].block.parameters["position"] = glm::dvec3(x, 0.0, 2.0);
        ASSERT_TRUE(renderer->capture(scene, view, meshSource(), false));
        EXPECT_EQ(renderer->report().compiled, 0);
        EXPECT_TRUE(isInTheFrame("lights/point"));
    }
}

TEST_F(LightListsTest, PrewarmedScene_HasTheProgramsOfADragToo) {
    makeRenderer();
    const Scene scene = twoSpheres();
    EXPECT_TRUE(prewarm(scene, viewOf(scene), meshSource()));
    EXPECT_FALSE(prewarm(scene, viewOf(scene), meshSource()));
    capture(scene);
    EXPECT_EQ(renderer->report().compiled, 0);
    const Scene held = scene;
    View view = viewOf(scene);
    view.effects = &held;
    ASSERT_TRUE(renderer->capture(scene, view, meshSource(), false));
    EXPECT_EQ(renderer->report().compiled, 0);
}

/// Lamps of one kind are one loop: it is needed while one of them is.
TEST_F(LightListsTest, Kind_IsMissingWhereAllOfItsLightsAre) {
    Scene scene;
    scene.lights = {lamp({0, 0, 0}, 1.0), spot(30.0), lamp({10, 0, 0}, 1.0)};
    LightLists lists;
    lists.begin(scene, *catalog);
    LightKinds kinds;
    kinds.begin(scene, *catalog);
    EXPECT_EQ(kinds.missingKinds(lists, lists.listFor({{0, 0, 0}, 0.5})), 0u);
    EXPECT_EQ(kinds.missingKinds(lists, 0), 0u);
    EXPECT_EQ(kinds.lights(0), nullptr);
    const auto lamps = kinds.missingKinds(lists, lists.listFor({{5, 0, 0}, 0.5}));
    const auto both = kinds.missingKinds(lists, lists.listFor({{-5, 0, 0}, 0.5}));
    EXPECT_NE(lamps, both);
    EXPECT_EQ(*kinds.lights(lamps), lightSet({0, 2}));
    EXPECT_EQ(*kinds.lights(both), lightSet({0, 1, 2}));
}

TEST_F(LightListsTest, ListsThatLackTheSameKinds_AreOneLack) {
    Scene scene;
    scene.lights = {spot(30.0), lamp({0, 0, 0}, 1.0), lamp({10, 0, 0}, 1.0)};
    scene.lights[0].block.parameters["range"] = 1.0;
    LightLists lists;
    lists.begin(scene, *catalog);
    LightKinds kinds;
    kinds.begin(scene, *catalog);
    const std::size_t first = lists.listFor({{-1.2, 0, 0}, 0.5});
    const std::size_t second = lists.listFor({{10, 0, 0}, 0.5});
    EXPECT_NE(first, second);
    EXPECT_EQ(kinds.missingKinds(lists, first), 1u);
    EXPECT_EQ(kinds.missingKinds(lists, second), 1u);
}

/// A hundred lamps beside the first sphere and none that reaches the second.
TEST_F(LightListsTest, HundredLamps_AreInNoProgramThatTheyDoNotReach) {
    makeRenderer();
    Scene scene = twoSpheres();
    scene.lights.resize(1);
    scene.lights.resize(101, lamp({-3.0, 0.0, 2.0}, 3.5));
    capture(scene);
    EXPECT_EQ(renderer->report().programs, 2);
    EXPECT_TRUE(row(scene, 0, "lights/point")->in);
    EXPECT_FALSE(row(scene, 1, "lights/point"));
    EXPECT_FALSE(row(scene, 1, "light 101")->in);
    scene.objects[0].visible = false;
    capture(scene);
    EXPECT_FALSE(isInTheFrame("lights/point"));
}

/// Each sphere has a lamp of its own, and there are more than there may be lists: the last ones are
/// shaded by all lamps, and say so.
TEST_F(LightListsTest, ObjectWithoutAListOfItsOwn_NamesAllLights) {
    Scene scene;
    for (int i = 0; i < 70; ++i) {
        scene.objects.push_back(object("lambert"));
        scene.objects.back().translation.x = 10.0 * i;
        scene.lights.push_back(lamp({10.0 * i, 0, 0}, 2.0));
    }
    constexpr std::size_t last = LightLists::maxCount - 2; // beside the list of all lights
    EXPECT_EQ(row(scene, last, "lights/point")->line.reason,
              fmt::format("light {} shines.", last + 1));
    EXPECT_TRUE(row(scene, last, "light 1"));
    EXPECT_EQ(row(scene, 69, "lights/point")->line.reason, "70 lights shine.");
    EXPECT_FALSE(row(scene, 69, "light 1"));
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

} // namespace
} // namespace patina::light_lists_test
