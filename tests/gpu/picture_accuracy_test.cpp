// SPDX-License-Identifier: GPL-3.0-or-later
// How far each level of the picture's accuracy is from the exact picture.
#include "scene/picture_accuracy.h"

#include <algorithm>
#include <cmath>

#include "gpu_fixture.h"
#include "measure/choice/choices.h"
#include "measure/cost/cost_sweep.h"
#include "measure/time/timed_frames.h"
#include "scene/picture_choice_text.h"

namespace patina::picture_accuracy_test {
namespace {

constexpr int size = 64;

struct Difference {
    double max = 0.0;
    double mean = 0.0;
};

class PictureAccuracyTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    static Scene with(Scene scene, std::string_view choice, std::string_view level) {
        const PictureChoiceText& text = *pictureChoiceText(choice);
        scene.accuracy.choose(text.choice, *text.level(level));
        return scene;
    }

    Image linear(const Scene& scene) { return capture(scene, false, size); }

    /// Compares linear values with the exact scene's picture.
    Difference difference(const Scene& scene, std::string_view choice, std::string_view level) {
        const Image exact = linear(scene);
        const Image other = linear(with(scene, choice, level));
        EXPECT_EQ(other.width, size);
        EXPECT_EQ(other.pixels.size(), exact.pixels.size());
        Difference found;
        for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
            const double error = std::abs(double(other.pixels[i]) - double(exact.pixels[i]));
            found.max = std::max(found.max, error);
            found.mean += error / double(exact.pixels.size());
        }
        return found;
    }

    static float brightest(const Image& image) {
        float max = 0.0f;
        for (int i = 0; i < image.width * image.height; ++i) {
            max = std::max(max, pixel(image, i % image.width, i / image.width).r);
        }
        return max;
    }

    Scene foggy() const {
        Scene scene = simpleScene();
        scene.setPart(kinds::fog, block("fog", "exponential"));
        scene.part(kinds::fog)->parameters["density"] = 0.2;
        return scene;
    }

    /// A grid with a highlight in the middle that is smaller than its squares, between corners.
    Scene shinyPlane() const {
        Scene scene = simpleScene("phong");
        scene.objects[0] = object("phong", "plane");
        scene.objects[0].rotation = glm::dvec3(90.0, 0.0, 0.0);
        scene.objects[0].material.model.parameters["shininess"] = 20000.0;
        scene.objects[0].translation = glm::dvec3(0.0625, 0.0625, 0.0);
        return scene;
    }
};

TEST_F(PictureAccuracyTest, NormalsAsBlended_DarkenASphereALittle) {
    const Scene scene = simpleScene();
    const Image exact = linear(scene);
    const Image blended = linear(with(scene, "normals", "interpolated"));
    for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
        ASSERT_LE(blended.pixels[i], exact.pixels[i] + 0.0005f);
    }
    const Difference found = difference(scene, "normals", "interpolated");
    EXPECT_GT(found.mean, 0.0);
    EXPECT_LT(found.max, 0.01);
}

TEST_F(PictureAccuracyTest, FogAtVertices_IsNearlyThatOfPixelsOnAFineMesh) {
    const Difference found = difference(foggy(), "fog", "vertex");
    EXPECT_GT(found.mean, 0.0);
    EXPECT_LT(found.max, 0.002);
}

TEST_F(PictureAccuracyTest, LightAtVertices_IsNearlyThatOfPixelsOnAMattSphere) {
    const Difference found = difference(simpleScene(), "lighting", "vertex");
    EXPECT_GT(found.mean, 0.0);
    EXPECT_LT(found.mean, 0.002);
    EXPECT_LT(found.max, 0.05);
}

TEST_F(PictureAccuracyTest, LightAtVertices_LosesAHighlightBetweenThem) {
    const Scene scene = shinyPlane();
    const float exact = middle(linear(scene)).r;
    const float lost = middle(linear(with(scene, "lighting", "vertex"))).r;
    EXPECT_LT(lost, 0.8f * exact);
}

TEST_F(PictureAccuracyTest, LightAtVertices_LightsBackSidesAsPixelsDo) {
    Scene scene = simpleScene();
    scene.objects[0] = object("lambert", "plane");
    scene.objects[0].rotation = glm::dvec3(-90.0, 0.0, 0.0); // its back to the viewer
    EXPECT_GT(middle(linear(scene)).r, 0.3f);
    EXPECT_LT(difference(scene, "lighting", "vertex").max, 0.001);
}

TEST_F(PictureAccuracyTest, WideHighlights_DoNotSparkle) {
    Scene scene = simpleScene("cook-torrance");
    Values& values = scene.objects[0].material.model.parameters;
    values["roughness"] = 0.02;
    values["diffuse.color"] = glm::dvec3(0.0);
    scene.camera.distance = 12.0;
    scene.background = glm::dvec3(0.0);
    const auto sparkle = [this](Scene moved) {
        std::vector<float> seen;
        for (int i = 0; i < 5; ++i) {
            moved.camera.pivot.x = 0.023 * i; // parts of a pixel
            seen.push_back(brightest(linear(moved)));
        }
        return std::ranges::max(seen) / std::ranges::min(seen);
    };
    EXPECT_GT(sparkle(with(scene, "samples", "1")), 3.0f);
    EXPECT_LT(sparkle(with(with(scene, "samples", "1"), "highlights", "widened")), 1.5f);
}

TEST_F(PictureAccuracyTest, SmallerScale_KeepsTheSizeAndBlursEdges) {
    const Scene scene = simpleScene();
    const Difference quarters = difference(scene, "scale", "three-quarters");
    const Difference half = difference(scene, "scale", "half");
    EXPECT_GT(half.mean, quarters.mean);
    EXPECT_GT(quarters.mean, 0.0);
    EXPECT_LT(half.mean, 0.02);
    EXPECT_NEAR(middle(linear(with(scene, "scale", "half"))).r, middle(linear(scene)).r, 0.002);
}

TEST_F(PictureAccuracyTest, SmallerScale_ShowsWhatIsRefractedInItsPlace) {
    Scene scene = simpleScene();
    scene.objects[0].material.opacity = 0.2;
    scene.objects[0].material.parts["refraction"] = block("refraction", "thin-pane");
    scene.objects.push_back(object("lambert", "cube"));
    scene.objects.back().translation = glm::dvec3(0.0, 0.0, -2.0);
    EXPECT_LT(difference(scene, "scale", "half").mean, 0.03);
}

TEST_F(PictureAccuracyTest, OneSample_LeavesNothingBetweenAShapeAndWhatIsBehind) {
    Scene scene = simpleScene();
    scene.objects[0].material.model.parameters["emissive.color"] = glm::dvec3(1.0);
    scene.lights.clear();
    const auto isBetween = [](float x) { return x > 0.26f && x < 0.99f; };
    EXPECT_TRUE(std::ranges::any_of(linear(scene).pixels, isBetween));
    EXPECT_FALSE(std::ranges::any_of(linear(with(scene, "samples", "1")).pixels, isBetween));
}

TEST_F(PictureAccuracyTest, WholeNumbers_AreFinerThanHalfOnesByTheirRounding) {
    const Difference found = difference(simpleScene(), "numbers", "full");
    EXPECT_GT(found.max, 0.0);
    EXPECT_LT(found.max, 0.001); // a half float below 1 has steps of 0.0005
}

TEST_F(PictureAccuracyTest, ChartOfThePicture_HasAPointForEveryLevel) {
    Scene scene = foggy();
    scene.lights[0].setPart(kinds::shadows, block("shadows", "filtered"));
    CostSweep::Options options;
    options.size = {24, 24};
    options.scope = Choice::Scope::Picture;
    options.pairs.max = 7;
    options.combinations = false;
    auto sweep = CostSweep::create({scene, 0, scene.camera, meshSource(), catalog}, options);
    ASSERT_TRUE(sweep);
    while (!(*sweep)->finished()) {
        (*sweep)->step(std::chrono::milliseconds(20));
    }
    EXPECT_EQ((*sweep)->problems(), Errors());
    for (const PictureChoiceText& text : pictureChoiceTexts()) {
        if (text.choice == PictureChoice::Environment) {
            continue; // the scene has none
        }
        for (const PictureChoiceText::Level& level : text.levels.subspan(1)) {
            const CostPoint* point =
                (*sweep)->chart().find({{std::string("picture.") + text.id, level.id}});
            ASSERT_NE(point, nullptr) << text.id << ' ' << level.id;
            EXPECT_GT(point->cost.runs, 0) << text.id;
        }
    }
    EXPECT_NE((*sweep)->chart().find({{"picture.shadows", "coarse"}}), nullptr);
    EXPECT_GT((*sweep)->chart().find({{"picture.scale", "half"}})->error.max, 0.01);
}

TEST_F(PictureAccuracyTest, LayersOfTheScene_HaveTheWeightedMeanAsTheirLastLevel) {
    Scene scene = simpleScene();
    scene.objects[0].material.opacity = 0.5;
    scene.setPart(kinds::transparency, block("transparency", "peeled"));
    const std::vector<Choice> choices = choicesOfPicture(scene, *catalog);
    const auto layers = std::ranges::find(choices, "picture.layers", &Choice::id);
    ASSERT_NE(layers, choices.end());
    EXPECT_EQ(layers->levels.front().id, "16");
    EXPECT_EQ(layers->levels.back().id, "weighted");
    ChosenFrame frame{scene, View()};
    choose(frame, 0, choices, {{"picture.layers", "weighted"}}, *catalog);
    EXPECT_EQ(frame.scene.part(kinds::transparency)->id, "weighted");
    ChosenFrame exact{scene, View()};
    choose(exact, 0, choices, {}, *catalog);
    EXPECT_EQ(exact.scene.part(kinds::transparency)->id, "peeled");
}

TEST_F(PictureAccuracyTest, DirectionsOfAnEnvironment_GoFrom4096To1AndThenToNone) {
    Scene scene = simpleScene();
    scene.setPart(kinds::environment, block("environment", "studio"));
    const std::vector<Choice> choices = choicesOfPicture(scene, *catalog);
    const auto directions = std::ranges::find(choices, "picture.environment", &Choice::id);
    ASSERT_NE(directions, choices.end());
    EXPECT_EQ(directions->levels.front().id, "4096");
    EXPECT_EQ((directions->levels.end() - 2)->id, "1");
    EXPECT_EQ(directions->levels.back().id, "fitted");
    ChosenFrame frame{scene, View()};
    choose(frame, 0, choices, {{"picture.environment", "1"}}, *catalog);
    EXPECT_EQ(frame.view.environmentSamples, 1);
    EXPECT_FALSE(frame.scene.accuracy.fitsEnvironment());
    ChosenFrame fitted{scene, View()};
    choose(fitted, 0, choices, {{"picture.environment", "fitted"}}, *catalog);
    EXPECT_TRUE(fitted.scene.accuracy.fitsEnvironment());
    EXPECT_EQ(levelsOfPicture(fitted.scene, choices, *catalog).at("picture.environment"), "fitted");
}

TEST_F(PictureAccuracyTest, MoreDirectionsThanOneFrameHas_TakeTheirTime) {
    Scene scene = simpleScene();
    scene.setPart(kinds::environment, block("environment", "studio"));
    auto drawn = TimedFrames::create({catalog, meshSource()}, {24, 24}, {});
    ASSERT_TRUE(drawn);
    const auto milliseconds = [&](int directions) {
        View view = viewOf(scene, 24);
        view.environmentSamples = directions;
        std::vector<double> times;
        for (int i = 0; i < 5; ++i) {
            times.push_back((*drawn)->timeOf(scene, view));
        }
        return std::ranges::min(times);
    };
    milliseconds(4);                                        // only warms up
    EXPECT_GT(milliseconds(1024), 2.0 * milliseconds(256)); // of which a draw has 256 at most
}

} // namespace
} // namespace patina::picture_accuracy_test
