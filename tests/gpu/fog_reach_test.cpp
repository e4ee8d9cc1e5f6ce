// SPDX-License-Identifier: GPL-3.0-or-later
// Fog in a box that nothing is seen through.
#include "render/lights/fog_reach.h"

#include <algorithm>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "gpu_fixture.h"
#include "render/surfaces/object_rows.h"
#include "render/surfaces/scene_depth.h"

namespace patina::fog_reach_test {
namespace {

class FogReachTest : public GpuTest {
  protected:
    Scene fogAt(const glm::dvec3& center, const glm::dvec3& size) const {
        Scene scene = simpleScene();
        scene.camera.distance = 4.0;
        scene.setPart(kinds::fog, block("fog", "box"));
        scene.part(kinds::fog)->parameters["density"] = 5.0;
        scene.part(kinds::fog)->parameters["center"] = center;
        scene.part(kinds::fog)->parameters["size"] = size;
        return scene;
    }

    /// Whether it is missed by what is seen of a cube of two metres a side.
    bool misses(const Scene& scene, const glm::dvec3& eye, const glm::dmat4& world) const {
        FogReach reach(scene, *catalog, eye);
        reach.add(cube(), world);
        return reach.misses();
    }

    static Bounds cube() {
        Bounds bounds;
        bounds.add(glm::vec3(-1.0f));
        bounds.add(glm::vec3(1.0f));
        return bounds;
    }

    bool isInTheFrame() const {
        return std::ranges::count(renderer->report().effects, "fog/box") > 0;
    }
};

const glm::dvec3 small(0.5);
const glm::dmat4 here(1.0);

TEST_F(FogReachTest, BoxBetweenEyeAndObject_IsMet) {
    EXPECT_FALSE(misses(fogAt({0, 0, 5}, small), {0, 0, 10}, here));
}

TEST_F(FogReachTest, BoxInTheObject_IsMet) {
    EXPECT_FALSE(misses(fogAt({0, 0, 0}, small), {0, 0, 10}, here));
}

TEST_F(FogReachTest, BoxAroundTheEye_IsMet) {
    EXPECT_FALSE(misses(fogAt({0, 0, 10}, small), {0, 0, 10}, here));
}

TEST_F(FogReachTest, BoxBesideBehindOrAtTheBack_IsMissed) {
    EXPECT_TRUE(misses(fogAt({3, 0, 5}, small), {0, 0, 10}, here));
    EXPECT_TRUE(misses(fogAt({0, 0, -2}, small), {0, 0, 10}, here));
    EXPECT_TRUE(misses(fogAt({0, 0, 12}, small), {0, 0, 10}, here));
}

/// The ball around the turned cube would touch it.
TEST_F(FogReachTest, BoxBesideATurnedObject_IsMissed) {
    const glm::dmat4 turned =
        glm::rotate(here, glm::radians(45.0), glm::normalize(glm::dvec3(0, 0, 1)));
    EXPECT_TRUE(misses(fogAt({1.2, 1.2, 0}, small), {0, 0, 10}, turned));
    EXPECT_FALSE(misses(fogAt({1.2, 1.2, 0}, small), {0, 0, 10}, here));
}

TEST_F(FogReachTest, OneOfTwoObjectsBehindIt_IsEnough) {
    const Scene scene = fogAt({20, 0, 5}, small);
    FogReach reach(scene, *catalog, {20, 0, 10});
    reach.add(cube(), here);
    EXPECT_TRUE(reach.misses());
    reach.add(cube(), glm::translate(here, {20, 0, 0}));
    EXPECT_FALSE(reach.misses());
}

TEST_F(FogReachTest, FogWithoutABox_IsNeverMissed) {
    Scene scene = simpleScene();
    scene.setPart(kinds::fog, block("fog", "exponential"));
    EXPECT_FALSE(misses(scene, {0, 0, 10}, here));
}

TEST_F(FogReachTest, EyeThatIsNowhere_MeetsIt) {
    const double nothing = std::nan("");
    EXPECT_FALSE(misses(fogAt({90, 0, 0}, small), {nothing, 0, 10}, here));
    EXPECT_FALSE(
        misses(fogAt({90, 0, 0}, small), {0, 0, 10}, glm::translate(here, {nothing, 0, 0})));
}

/// Whether the way from the eye to a point meets a box, as the fog's shader has it.
bool meets(const FogBox& box, const glm::dvec3& eye, const glm::dvec3& point) {
    double from = 0.0;
    double to = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = box.center[axis] - eye[axis];
        const double way = point[axis] - eye[axis];
        const double a = (middle - 0.5 * box.size[axis]) / way;
        const double b = (middle + 0.5 * box.size[axis]) / way;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from < to;
}

/// Against rays to points of the object: none may meet a box that is missed, and most of the others
/// are met by one.
TEST_F(FogReachTest, RandomBoxes_AreMissedWhereNoRayMeetsThem) {
    std::mt19937 random(4);
    const auto within = [&random](double bound) {
        return std::uniform_real_distribution<double>(-bound, bound)(random);
    };
    const auto point = [&within](double bound) {
        return glm::dvec3(within(bound), within(bound), within(bound));
    };
    int missed = 0;
    int met = 0;
    int metUnseen = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 eye = point(8.0);
        const glm::dmat4 world =
            glm::rotate(glm::translate(here, point(4.0)), within(3.0), glm::normalize(point(1.0)));
        const glm::dvec3 between = glm::mix(eye, glm::dvec3(world[3]), 0.5 + within(0.5));
        const FogBox box{between + point(3.0), glm::abs(point(2.0))};
        bool isSeen = false;
        for (int ray = 0; ray < 400 && !isSeen; ++ray) {
            isSeen = meets(box, eye, glm::dvec3(world * glm::dvec4(point(1.0), 1.0)));
        }
        const bool isMissed = misses(fogAt(box.center, box.size), eye, world);
        ASSERT_FALSE(isMissed && isSeen) << i;
        missed += isMissed ? 1 : 0;
        met += isSeen ? 1 : 0;
        metUnseen += !isMissed && !isSeen ? 1 : 0;
    }
    EXPECT_GT(missed, 300);
    EXPECT_GT(met, 300);
    EXPECT_LT(metUnseen, 200); // the margin, and boxes that few rays meet
}

TEST_F(FogReachTest, BoxFarFromTheObjects_IsInNoProgram) {
    makeRenderer();
    Scene scene = fogAt({0.0, 0.0, 2.0}, small);
    const Image with = capture(scene);
    EXPECT_TRUE(isInTheFrame());
    scene.part(kinds::fog)->parameters["center"] = glm::dvec3(500.0, 0.0, 0.0);
    const Image away = capture(scene);
    EXPECT_FALSE(isInTheFrame());
    EXPECT_TRUE(objectView(scene, 0, *catalog, meshSource()).missesFog);
    scene.setPart(kinds::fog, std::nullopt);
    EXPECT_EQ(capture(scene).pixels, away.pixels);
    EXPECT_NE(with.pixels, away.pixels);
}

/// The ground lies behind it.
TEST_F(FogReachTest, BoxOverTheGround_IsInThePrograms) {
    makeRenderer();
    Scene scene = fogAt({4.0, -0.4, 0.0}, small);
    scene.camera.pitch = 20.0;
    capture(scene);
    EXPECT_FALSE(isInTheFrame());
    scene.ground.mode = GroundMode::Plane;
    capture(scene);
    EXPECT_TRUE(isInTheFrame());
    EXPECT_FALSE(objectView(scene, 0, *catalog, meshSource()).missesFog);
}

TEST_F(FogReachTest, RowOfABoxThatIsMissed_SaysSo) {
    const Scene scene = fogAt({500.0, 0.0, 0.0}, small);
    const auto rows = objectRows(scene, 0, *catalog, meshSource());
    const auto fog =
        std::ranges::find_if(rows, [](const EffectRow& row) { return row.line.effect == "fog"; });
    ASSERT_NE(fog, rows.end());
    EXPECT_FALSE(fog->in);
    EXPECT_TRUE(fog->line.reason.ends_with("nothing that is drawn lies in its box or is seen "
                                           "through it."))
        << fog->line.reason;
}

/// Fog on the ground under a ball of one metre at y = 0, seen from 4 m away.
class FogLayerTest : public FogReachTest {
  protected:
    Scene fogUpTo(double base, double thickness) const {
        Scene scene = simpleScene();
        scene.camera.distance = 4.0;
        scene.setPart(kinds::fog, block("fog", "height"));
        scene.part(kinds::fog)->parameters["base"] = base;
        scene.part(kinds::fog)->parameters["thickness"] = thickness;
        return scene;
    }

    bool isDrawn(const Scene& scene) {
        capture(scene);
        return std::ranges::count(renderer->report().effects, "fog/height") > 0;
    }

    EffectRow row(const Scene& scene) {
        for (const EffectRow& each : objectRows(scene, 0, *catalog, meshSource())) {
            if (each.line.effect.starts_with("fog")) {
                return each;
            }
        }
        return {};
    }
};

TEST_F(FogLayerTest, BelowTheObject_IsInNoProgramAndInNoPixel) {
    makeRenderer();
    Scene scene = fogUpTo(-1.5, 0.02);
    EXPECT_FALSE(isDrawn(scene));
    const Image with = capture(scene, true);
    scene.setPart(kinds::fog, std::nullopt);
    EXPECT_EQ(capture(scene, true).pixels, with.pixels);
}

/// What is left out could be seen nowhere: the bound against the fog in the frame.
TEST_F(FogLayerTest, JustLeftOut_ChangesNoPixelByHalfAStep) {
    makeRenderer();
    const Block& fog = *catalog->find("fog", "height");
    double base = -0.9;
    Scene scene = fogUpTo(base, 0.1);
    while (isDrawn(scene)) {
        base -= 0.05;
        scene = fogUpTo(base, 0.1);
    }
    ASSERT_GT(base, -4.0);
    const Image without = capture(scene, true, 65);
    auto silent = std::make_shared<Catalog>(*catalog);
    for (Block& each : silent->blocks) {
        if (each.kind == "fog" && each.id == fog.id) {
            each.hides.reset();
        }
    }
    renderer->setCatalog(silent);
    ASSERT_TRUE(isDrawn(scene));
    const Image with = capture(scene, true, 65);
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
        ASSERT_NEAR(with.pixels[i], without.pixels[i], halfStep);
    }
}

TEST_F(FogLayerTest, CameraInIt_KeepsIt) {
    makeRenderer();
    Scene scene = fogUpTo(-1.5, 0.02);
    scene.camera.pitch = -60.0; // 3.5 m below the ball
    EXPECT_TRUE(isDrawn(scene));
}

TEST_F(FogLayerTest, ObjectPartlyInIt_KeepsIt) {
    makeRenderer();
    EXPECT_TRUE(isDrawn(fogUpTo(-0.9, 0.02)));
    EXPECT_TRUE(isDrawn(fogUpTo(-0.9, 0.0)));
}

TEST_F(FogLayerTest, SecondObjectInIt_KeepsIt) {
    makeRenderer();
    Scene scene = fogUpTo(-1.5, 0.02);
    scene.objects.push_back(object("lambert"));
    scene.objects[1].translation.y = -3.0;
    EXPECT_TRUE(isDrawn(scene));
}

TEST_F(FogLayerTest, Ground_KeepsIt) {
    makeRenderer();
    Scene scene = fogUpTo(-0.99, 0.02);
    scene.camera.pitch = 20.0;
    scene.ground.mode = GroundMode::Plane;
    EXPECT_TRUE(isDrawn(scene));
}

TEST_F(FogLayerTest, RowOfFogThatThinsOutBelow_SaysSo) {
    const EffectRow out = row(fogUpTo(-1.5, 0.02));
    EXPECT_FALSE(out.in);
    EXPECT_TRUE(out.line.reason.starts_with(
        "Density 0.4, Base -1.5 m, Thickness 0.02 m: it thins out below what is drawn, and "
        "changes its pixels by less than 0.01 %."))
        << out.line.reason;
    EXPECT_TRUE(row(fogUpTo(-0.5, 0.5)).in);
}

TEST_F(FogLayerTest, MeanDensity_IsThatOfManySteps) {
    for (const FogLayer layer : {FogLayer{0.0, 1.0}, FogLayer{1.0, 0.3}, FogLayer{-2.0, 5.0}}) {
        for (const auto& [one, other] : {std::pair{-3.0, 4.0}, std::pair{2.5, 0.5},
                                         std::pair{1.5, 3.0}, std::pair{-5.0, -4.0}}) {
            double sum = 0.0;
            const int steps = 20000;
            for (int i = 0; i < steps; ++i) {
                const double y = one + (other - one) * (i + 0.5) / steps;
                sum += std::exp(-std::max(y - layer.base, 0.0) / layer.thickness);
            }
            EXPECT_NEAR(layer.between(one, other), sum / steps, 1e-6) << one << ' ' << other;
        }
        EXPECT_EQ(layer.between(layer.base, layer.base), 1.0);
    }
    EXPECT_EQ((FogLayer{0.0, 0.0}.between(0.5, 1.0)), 0.0);
    EXPECT_NEAR((FogLayer{0.0, 0.0}.between(-1.0, 3.0)), 0.25, 1e-6);
}

/// The whole bound: the greatest thickness on the way to a corner, of many ways into a box.
TEST_F(FogLayerTest, RandomWays_HaveNoMoreOfItThanIsSaid) {
    std::mt19937 random(7);
    const auto within = [&random](double bound) {
        return std::uniform_real_distribution<double>(-bound, bound)(random);
    };
    for (int i = 0; i < 300; ++i) {
        Scene scene = fogUpTo(within(3.0), 1.0 + within(1.0));
        const FogLayer layer =
            *fogLayer(*catalog->find("fog", "height"), scene.part(kinds::fog)->parameters);
        const glm::dvec3 eye(within(6.0), within(6.0), within(6.0));
        const glm::dmat4 world = glm::translate(here, {within(4.0), within(4.0), within(4.0)});
        FogReach reach(scene, *catalog, eye);
        reach.add(cube(), world);
        for (int ray = 0; ray < 20; ++ray) {
            const glm::dvec3 point(world * glm::dvec4(within(1.0), within(1.0), within(1.0), 1.0));
            ASSERT_LE(layer.between(eye.y, point.y), reach.thickness()) << i;
        }
    }
}

} // namespace
} // namespace patina::fog_reach_test
