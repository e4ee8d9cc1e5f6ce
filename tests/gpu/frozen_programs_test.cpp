// SPDX-License-Identifier: GPL-3.0-or-later
// A view whose programs have the effects of another scene: what a drag across zero is drawn with.
#include <functional>
#include <ostream>
#include <string>

#include "gpu_fixture.h"

namespace patina::frozen_programs_test {
namespace {

/// A value that decides about an effect, and 0 .. 1 of how much of the effect it brings.
struct Dragged {
    std::string name;
    std::function<void(Scene&, double)> set;

    friend std::ostream& operator<<(std::ostream& out, const Dragged& dragged) {
        return out << dragged.name;
    }
};

class FrozenPrograms : public GpuTest, public testing::WithParamInterface<Dragged> {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        scene_ = simpleScene("phong");
        scene_.lights.push_back(light("point"));
        scene_.setPart(kinds::fog, block("fog", "exponential"));
        scene_.ambient = glm::dvec3(0.0);
        for (const Dragged& other : {intensity(), opacity(), ambient(), density()}) {
            other.set(scene_, other.name == GetParam().name ? 0.0 : 0.5);
        }
        effects_ = scene_;
        GetParam().set(effects_, 0.5);
    }

    Image drawn(bool held) {
        View view = viewOf(scene_);
        view.effects = held ? &effects_ : nullptr;
        auto image = renderer->capture(scene_, view, meshSource(), false);
        EXPECT_TRUE(image);
        return image ? *image : Image();
    }

  public:
    static Dragged intensity() {
        return {"Intensity", [](Scene& scene, double share) {
                    scene.lights[1].block.parameters["intensity"] = share;
                }};
    }
    static Dragged opacity() {
        return {"Opacity", [](Scene& scene, double share) {
                    scene.objects[0].material.opacity = 1.0 - share;
                }};
    }
    static Dragged ambient() {
        return {"Ambient", [](Scene& scene, double share) { scene.ambient = glm::dvec3(share); }};
    }
    static Dragged density() {
        return {"Density", [](Scene& scene, double share) {
                    scene.part(kinds::fog)->parameters["density"] = share;
                }};
    }

  protected:
    Scene scene_;
    Scene effects_;
};

TEST_P(FrozenPrograms, DragAcrossZero_CompilesNothing) {
    drawn(true);
    int compiled = 0;
    for (const double share : {0.1, 0.0, 0.7, 0.0}) {
        GetParam().set(scene_, share);
        drawn(true);
        compiled += renderer->report().compiled;
    }
    EXPECT_EQ(compiled, 0);
}

TEST_P(FrozenPrograms, WithoutThem_AnotherProgramIsCompiled) {
    drawn(false);
    GetParam().set(scene_, 0.5);
    drawn(false);
    EXPECT_GT(renderer->report().compiled, 0);
}

TEST_P(FrozenPrograms, ValueWithoutEffect_LooksAsItDoesInItsOwnProgram) {
    const Image held = drawn(true);
    const Image own = drawn(false);
    ASSERT_EQ(held.pixels.size(), own.pixels.size());
    for (std::size_t i = 0; i < own.pixels.size(); ++i) {
        ASSERT_NEAR(held.pixels[i], own.pixels[i], 1e-3 * (1.0 + own.pixels[i])) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Values, FrozenPrograms,
                         testing::Values(FrozenPrograms::intensity(), FrozenPrograms::opacity(),
                                         FrozenPrograms::ambient(), FrozenPrograms::density()),
                         [](const auto& tested) { return tested.param.name; });

class ReleasedTargets : public GpuTest {};

TEST_F(ReleasedTargets, NextFrame_IsTheSame) {
    makeRenderer();
    const Scene scene = simpleScene("phong");
    const Image before = capture(scene);
    renderer->job().releaseTargets();
    EXPECT_EQ(capture(scene).pixels, before.pixels);
}

TEST_F(ReleasedTargets, BeforeAnyFrame_DoNoHarm) {
    makeRenderer();
    renderer->job().releaseTargets();
    EXPECT_FALSE(capture(simpleScene("phong")).pixels.empty());
}

class Prewarmed : public GpuTest {};

TEST_F(Prewarmed, PictureWithoutExposure_CompilesNothingWhenItComes) {
    makeRenderer();
    Scene scene = simpleScene();
    scene.exposure = 1.0;
    capture(scene, true);
    Scene without = scene;
    without.exposure = 0.0;
    View ahead = viewOf(scene);
    ahead.effects = &without;
    EXPECT_TRUE(prewarm(scene, ahead, meshSource()));
    capture(without, true);
    EXPECT_EQ(renderer->report().compiled, 0);
}

} // namespace
} // namespace patina::frozen_programs_test
