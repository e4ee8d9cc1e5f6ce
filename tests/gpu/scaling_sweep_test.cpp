// SPDX-License-Identifier: GPL-3.0-or-later
// How times grow, and what is drawn to find that out.
#include "measure/cost/scaling_sweep.h"

#include <algorithm>

#include "gpu_fixture.h"
#include "measure/cost/scaling_scenes.h"

namespace patina::scaling_sweep_test {
namespace {

using Axis = ScalingCurve::Axis;

GrowthSample sample(double count, double milliseconds) {
    return {count, {milliseconds, milliseconds, milliseconds}};
}

TEST(GrowthLaw, StraightLine_IsFound) {
    const auto law = growthLaw({sample(1, 2.5), sample(4, 4.0), sample(64, 34.0)});
    ASSERT_TRUE(law);
    EXPECT_EQ(law->shape(), GrowthLaw::Shape::Linear);
    EXPECT_NEAR(law->base, 2.0, 1e-12);
    EXPECT_NEAR(law->each, 0.5, 1e-12);
    EXPECT_NEAR(law->fit, 1.0, 1e-12);
}

TEST(GrowthLaw, Square_HasTheExponentTwo) {
    const auto law =
        growthLaw({sample(1, 3), sample(2, 12), sample(4, 48), sample(8, 192), sample(16, 768)});
    ASSERT_TRUE(law);
    EXPECT_EQ(law->shape(), GrowthLaw::Shape::Power);
    EXPECT_NEAR(law->exponent, 2.0, 1e-12);
    EXPECT_NEAR(law->at(3.0), 27.0, 1e-9);
}

TEST(GrowthLaw, TimesThatHardlyDiffer_AreConstant) {
    const auto law = growthLaw({sample(1, 1.0), sample(10, 1.05), sample(100, 1.02)});
    ASSERT_TRUE(law);
    EXPECT_EQ(law->shape(), GrowthLaw::Shape::Constant);
}

TEST(GrowthLaw, TooFewTimes_HaveNone) {
    EXPECT_FALSE(growthLaw({sample(1, 1.0), sample(2, 2.0)}));
    EXPECT_FALSE(growthLaw({sample(1, 0.0), sample(2, 2.0), sample(3, 3.0)}));
}

TEST(LawText, OfAnotherCountry_HasItsNumbers) {
    ScalingCurve curve{Axis::Lights, {sample(1, 2.5), sample(4, 4.0), sample(64, 34.0)}, {}};
    curve.law = growthLaw(curve.samples);
    EXPECT_EQ(lawText(curve), "linear: 2 ms + 0.5 ms per light, R² 1.000");
    const auto withComma = [](double number, char format, int digits) {
        std::string text = plainNumber(number, format, digits);
        std::ranges::replace(text, '.', ',');
        return text;
    };
    EXPECT_EQ(lawText(curve, withComma), "linear: 2 ms + 0,5 ms per light, R² 1,000");
}

TEST(LawText, OfLargeNumbers_HasNoExponents) {
    ScalingCurve curve{Axis::Pixels, {sample(1e4, 96.0), sample(1e5, 951.0), sample(1e6, 9501.0)},
                       {}};
    curve.law = growthLaw(curve.samples);
    EXPECT_EQ(lawText(curve), "linear: 1 ms + 9500 ms per million pixels, R² 1.000");
}

TEST(LawText, OfACurve_SaysWhatTwiceAsManyTake) {
    ScalingCurve curve{Axis::Objects, {sample(1, 1.0), sample(4, 2.0), sample(16, 4.0)}, {}};
    curve.law = growthLaw(curve.samples);
    const std::string text = lawText(curve);
    EXPECT_TRUE(text.starts_with("twice the objects take 1.41 times as long")) << text;
}

TEST(ScalingText, TooFewRounds_AreMarked) {
    ScalingCurve curve{Axis::Lights, {{1.0, {2.0, 1.0, 3.0}, 5}}, {}};
    EXPECT_NE(scalingText({curve}).find("(1.000 .. 3.000)!\n"), std::string::npos);
    EXPECT_NE(scalingText({curve}).find("! too few"), std::string::npos);
    curve.samples[0].runs = 6;
    EXPECT_EQ(scalingText({curve}).find('!'), std::string::npos);
}

class ScalingSweepTest : public GpuTest {};

TEST_F(ScalingSweepTest, Lights_AreThoseThatAreOnAgainAndAgain) {
    Scene scene = simpleScene();
    scene.lights = {light("directional"), light("point"), light("spot")};
    scene.lights[1].enabled = false;
    const Scene more = withLights(scene, 5);
    ASSERT_EQ(more.lights.size(), 5u);
    EXPECT_EQ(more.lights[0].block.id, more.lights[4].block.id);
    EXPECT_EQ(more.lights[1].block.id, scene.lights[2].block.id);
}

TEST_F(ScalingSweepTest, Copies_CoverAboutAsMuchOfThePicture) {
    const Scene scene = simpleScene();
    makeRenderer();
    View view;
    view.size = {64, 64};
    view.camera = scene.camera;
    view.samples = 1;
    const auto covered = [&](const Scene& drawn) {
        const auto image = renderer->capture(drawn, view, meshSource(), false);
        std::size_t pixels = 0;
        for (std::size_t i = 0; image && i < image->pixels.size(); i += 4) {
            pixels += image->pixels[i] != image->pixels[0] ? 1 : 0; // the corner is background
        }
        return double(pixels);
    };
    const double one = covered(scene);
    ASSERT_GT(one, 100.0);
    EXPECT_NEAR(covered(withCopies(scene, 0, 16)) / one, 1.0, 0.35);
}

TEST_F(ScalingSweepTest, WithoutTime_EndsAfterARoundOfEachAxis) {
    const Scene scene = simpleScene();
    ScalingSweep::Options options;
    options.edges = {16, 32};
    options.lights = {1, 4};
    options.objects = {1, 4};
    options.edge = 16;
    options.seconds = 1e-9;
    auto sweep = ScalingSweep::create({scene, 0, scene.camera, meshSource(), catalog}, options);
    ASSERT_TRUE(sweep);
    while (!(*sweep)->finished()) {
        (*sweep)->step();
        EXPECT_LE((*sweep)->progress(), 1.0);
    }
    EXPECT_EQ((*sweep)->rounds(), 3);
    EXPECT_EQ((*sweep)->curves().size(), 3u);
    EXPECT_EQ((*sweep)->curves()[0].samples[0].runs, 1);
}

TEST_F(ScalingSweepTest, EveryAxis_HasATimeForEachCount) {
    const Scene scene = simpleScene();
    ScalingSweep::Options options;
    options.edges = {16, 32, 64};
    options.lights = {1, 4};
    options.objects = {1, 4, 9};
    options.edge = 32;
    options.rounds = 2;
    auto sweep = ScalingSweep::create({scene, 0, scene.camera, meshSource(), catalog}, options);
    ASSERT_TRUE(sweep);
    while (!(*sweep)->finished()) {
        (*sweep)->step();
    }
    EXPECT_EQ((*sweep)->problems(), Errors());
    ASSERT_EQ((*sweep)->curves().size(), 3u);
    EXPECT_EQ((*sweep)->curves()[0].samples.size(), 3u);
    EXPECT_EQ((*sweep)->curves()[1].axis, Axis::Lights);
    for (const ScalingCurve& curve : (*sweep)->curves()) {
        for (const GrowthSample& each : curve.samples) {
            EXPECT_GT(each.milliseconds.median, 0.0);
        }
    }
}

} // namespace
} // namespace patina::scaling_sweep_test
