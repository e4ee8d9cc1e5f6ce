// SPDX-License-Identifier: GPL-3.0-or-later
// The light of a whole environment from fitted lobes, against theory and against sampled
// directions.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "environment_fixture.h"
#include "material/preset_file.h"
#include "measure/error/flip.h"
#include "measured/kept_tables.h"
#include "render/lights/environment_harmonics.h"
#include "scene/scene_file.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "support/long_form.h"

namespace patina::fitted_environment_test {
namespace {

class FittedEnvironmentTest : public EnvironmentTest {
  protected:
    Scene fitted(Scene scene) {
        scene.accuracy.choose(PictureChoice::Environment, 1);
        return scene;
    }

    Scene ball(const std::string& model) {
        Scene scene = inTheStudio(model);
        scene.objects[0].mesh = "builtin:sphere";
        return scene;
    }
};

double meanOf(const Image& image) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        sum += image.pixels[i] + image.pixels[i + 1] + image.pixels[i + 2];
    }
    return sum / (0.75 * double(image.pixels.size()));
}

std::vector<glm::dvec3> colorsOf(const Image& image) {
    std::vector<glm::dvec3> colors;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        colors.emplace_back(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
    }
    return colors;
}

TEST_F(FittedEnvironmentTest, WhiteSurfaceUnderAWhiteSky_IsWhite) {
    Scene scene = fitted(surrounded("lambert", plain(1.0f)));
    makeWhite(scene);
    scene.objects[0].mesh = "builtin:sphere";
    const Image image = settled(scene, 4);
    for (const int x : {10, 16, 22}) {
        EXPECT_NEAR(pixel(image, x, 16).r, 1.0f, 0.01f) << x;
    }
}

/// Drawings are left out, which are lit from behind, and the grating: its lines are finer than the
/// directions of a fit lie apart, so its colours there are off by up to a third of a channel.
TEST_F(FittedEnvironmentTest, EveryModel_SendsTheLightOfAWhiteSkyThatItSendsWhenSampled) {
    for (const Block* model : catalog->ofKind(kinds::models)) {
        if (!model->hasGate("light") || model->id == "grating") {
            continue;
        }
        Scene scene = surrounded(model->id, plain(1.0f));
        size_ = 9;
        scene.objects[0].rotation = {0.0, 35.0, 0.0};
        const glm::vec3 right = middle(settled(scene, 4096));
        const glm::vec3 shown = middle(settled(fitted(scene), 4));
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(shown[i], right[i], 0.02f * right[i] + 0.002f) << model->id << ' ' << i;
        }
    }
}

TEST_F(FittedEnvironmentTest, MeasuredSurface_IsFittedAgainWhenItsFileArrives) {
    size_ = 9;
    const Scene scene = fitted(surrounded("measured", plain(1.0f)));
    auto white = std::make_shared<HalfDifferenceTable>();
    white->texels.front() = glm::vec3(std::numbers::inv_pi_v<float>);
    bool isThere = false;
    renderer->setTables([&](int) { return isThere ? white : keptTable(0); });
    const float before = middle(settled(scene, 4)).r;
    isThere = true;
    EXPECT_NEAR(middle(settled(scene, 4)).r, 2.0f * before, 0.05f);
    renderer->setTables(keptTable);
}

TEST_F(FittedEnvironmentTest, GlossyBallInTheStudio_LooksAsWhenSampled) {
    for (const double roughness : {0.05, 0.2, 0.5}) {
        Scene scene = ball("cook-torrance");
        scene.objects[0].material.model.parameters["roughness"] = roughness;
        const Image right = settled(scene, 1024);
        const Image shown = settled(fitted(scene), 4);
        EXPECT_NEAR(meanOf(shown) / meanOf(right), 1.0, 0.02) << roughness;
        double apart = 0.0;
        for (std::size_t i = 0; i < right.pixels.size(); ++i) {
            apart += std::abs(right.pixels[i] - shown.pixels[i]) / double(right.pixels.size());
        }
        EXPECT_LT(apart, 0.1 * meanOf(right)) << roughness;
    }
}

/// Fitted by a table, and at each pixel as where an image changes what is reflected.
TEST_F(FittedEnvironmentTest, EveryModelAtItsLimits_GivesFiniteLight) {
    size_ = 9;
    for (const Block* model : catalog->ofKind(kinds::models)) {
        Scene scene = fitted(ball(model->id));
        Material& material = scene.objects[0].material;
        const auto image = std::ranges::find_if(
            model->parameters, [](const Parameter& each) { return !each.textureChannels.empty(); });
        for (const bool isHighest : {false, true}) {
            for (const Parameter& parameter : model->parameters) {
                if (hasLimits(parameter)) {
                    material.model.parameters[parameter.id] =
                        allOf(parameter, isHighest ? parameter.max : parameter.min);
                }
            }
            for (const bool isPerPixel : {false, true}) {
                material.textures.clear();
                if (isPerPixel && image != model->parameters.end()) {
                    material.textures[image->id] = textureUse(image->id, "/nowhere.png"); // white
                }
                for (const float number : settled(scene, 4).pixels) {
                    ASSERT_TRUE(std::isfinite(number) && number >= 0.0f)
                        << model->id << (isHighest ? " highest" : " lowest")
                        << (isPerPixel ? " with an image" : "");
                }
            }
        }
    }
}

TEST_F(FittedEnvironmentTest, OneFrame_IsAllOfIt) {
    const Scene scene = fitted(ball("cook-torrance"));
    const Image first = settled(scene, 4);
    EXPECT_EQ(renderer->job().environmentSamples(), 0);
    EXPECT_EQ(settled(scene, 64).pixels, first.pixels);
}

TEST_F(FittedEnvironmentTest, ViewThatMoves_ShowsTheFittedPictureOfASampledScene) {
    const Scene scene = ball("cook-torrance");
    View moving = viewWith(scene, 4);
    moving.isMoving = true;
    const auto shown = renderer->capture(scene, moving, squares(), false);
    ASSERT_TRUE(shown);
    EXPECT_EQ(renderer->job().environmentSamples(), 0);
    EXPECT_EQ(settled(scene, 8).pixels.size(), shown->pixels.size());
    EXPECT_EQ(renderer->job().environmentSamples(), 8);
    EXPECT_EQ(settled(fitted(scene), 4).pixels, shown->pixels);
}

TEST_F(FittedEnvironmentTest, ViewThatMoved_ComesToRestWithTheSamePictureAsBefore) {
    for (const char* backdrop : {"sharp", "blurred", "hidden"}) {
        makeRenderer(); // which has fitted nothing yet
        Scene scene = ball("cook-torrance");
        scene.part(kinds::environment)->parameters["background"] = std::string(backdrop);
        const Image before = settled(scene, 8);
        View moving = viewWith(scene, 4);
        moving.isMoving = true;
        ASSERT_TRUE(renderer->capture(scene, moving, squares(), false));
        EXPECT_EQ(settled(scene, 8).pixels, before.pixels) << backdrop;
        const auto again = renderer->capture(scene, moving, squares(), false);
        ASSERT_TRUE(again);
        EXPECT_EQ(settled(fitted(scene), 4).pixels, again->pixels) << backdrop;
    }
}

/// What a drag ends in is as bright as what it showed.
TEST_F(FittedEnvironmentTest, ViewThatMoves_IsAsBrightAsAtRestForManyPresets) {
    const std::vector<const char*> presets{
        "cook-torrance/red-plastic", "cook-torrance/gold-polished", "lambert/grey-card",
        "oren-nayar/clay",           "phong/billiard-ball",         "strauss/frosted-steel",
        "gaussian/glazed-tile",      "he-torrance/copper-roughened"};
    for (const char* preset : tests::everyNth(presets, 3)) {
        const auto file = std::filesystem::path(PATINA_SOURCE_DIR "/presets") /
                          (std::string(preset) + ".patina.json");
        const auto read = readPreset(file, *catalog);
        ASSERT_TRUE(read) << preset;
        Scene scene = ball("lambert");
        scene.objects[0].material = read->material;
        View moving = viewWith(scene, 4);
        moving.isMoving = true;
        const auto shown = renderer->capture(scene, moving, squares(), true);
        const auto rested = renderer->capture(scene, viewWith(scene, 512), squares(), true);
        ASSERT_TRUE(shown && rested);
        EXPECT_NEAR(meanOf(*shown) / meanOf(*rested), 1.0, 0.02) << preset;
    }
}

/// Some have images, where the light is fitted at each pixel.
TEST_F(FittedEnvironmentTest, PresetsOfAllSorts_LookAsWhenSampled) {
    size_ = 64;
    const std::filesystem::path presets = PATINA_SOURCE_DIR "/presets";
    Scene scene = readScene(presets / "three-lights.patina-scene.json", *catalog).value().scene;
    scene.objects.resize(1);
    scene.lights.clear();
    scene.setPart(kinds::environment, block("environment", "studio"));
    for (const char* preset :
         tests::everyNth<const char*>({"oren-nayar/felt", "cook-torrance/red-plastic",
                                       "lommel-seeliger/moon-dust", "minnaert/velvet"},
                                      2)) {
        const std::filesystem::path file = presets / (std::string(preset) + ".patina.json");
        scene.objects[0].material = readPreset(file, *catalog).value().material;
        const auto right = renderer->capture(scene, viewWith(scene, 512), squares(), true);
        const auto shown = renderer->capture(fitted(scene), viewWith(scene, 4), squares(), true);
        ASSERT_TRUE(right && shown);
        const std::vector<glm::dvec3> colors = colorsOf(*right);
        const std::vector<double> map =
            Flip(glm::ivec2(size_), colors).differences(colorsOf(*shown));
        const double flip =
            std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
        EXPECT_LT(flip, 0.065) << preset; // 0.06, and the grain of 512 directions
    }
}

TEST_F(FittedEnvironmentTest, ScenesThatFitTheirLightWhileTheyMove_AreThoseWhoseLightIsSampled) {
    Scene scene = ball("cook-torrance");
    EXPECT_TRUE(fitsWhileMoving(scene, *catalog));
    EXPECT_FALSE(fitsWhileMoving(fitted(scene), *catalog));
    scene.objects.push_back(object("toon"));
    EXPECT_FALSE(fitsWhileMoving(scene, *catalog)); // its look would change
    scene.objects[1].visible = false;
    EXPECT_TRUE(fitsWhileMoving(scene, *catalog));
    scene.part(kinds::environment)->parameters["intensity"] = 0.0;
    EXPECT_FALSE(fitsWhileMoving(scene, *catalog));
}

TEST_F(FittedEnvironmentTest, LobesAreFittedWhereAValueChangesAndCompileNothing) {
    Scene scene = fitted(ball("cook-torrance"));
    settled(scene, 4);
    settled(scene, 4);
    EXPECT_EQ(renderer->report().filledTables, 0);
    scene.objects[0].material.model.parameters["roughness"] = 0.31;
    settled(scene, 4);
    EXPECT_EQ(renderer->report().filledTables, 1);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(FittedEnvironmentTest, NothingOfOneWayIsInTheTextOfTheOther) {
    const Scene scene = ball("cook-torrance");
    const auto textOf = [&](const Scene& shown) {
        const EffectSet set = effectSet(shown.objects[0].material, shown, *catalog);
        return surfaceProgram(set, *catalog, SurfaceOutput::Picture, 1024)->fragment.text;
    };
    EXPECT_EQ(textOf(scene).find("lobeTable"), std::string::npos);
    EXPECT_EQ(textOf(fitted(scene)).find("environmentTable"), std::string::npos);
}

TEST_F(FittedEnvironmentTest, MaterialThatImagesChange_IsFittedAtEachPixel) {
    size_ = 17;
    for (const double roughness : {0.1, 0.4}) {
        Scene scene = ball("cook-torrance");
        scene.objects[0].material.model.parameters["roughness"] = roughness;
        const Image right = settled(scene, 1024);
        scene.objects[0].material.textures["diffuse.color"] =
            textureUse("diffuse.color", "/nowhere.png"); // white
        scene = fitted(scene);
        const EffectSet set = effectSet(scene.objects[0].material, scene, *catalog);
        EXPECT_EQ(set.method, EnvironmentMethod::PerPixel);
        EXPECT_NEAR(meanOf(settled(scene, 4)) / meanOf(right), 1.0, 0.05) << roughness;
    }
}

/// What is left of a rough surface's light beside a matte part is seen by few of the half vectors.
TEST_F(FittedEnvironmentTest, RoughBallThatImagesChange_MirrorsNoLamps) {
    size_ = 33;
    Scene scene = ball("oren-nayar");
    scene.objects[0].material.model.parameters["roughness"] = 1.0;
    const Image right = settled(scene, 1024);
    scene.objects[0].material.textures["diffuse.color"] =
        textureUse("diffuse.color", "/nowhere.png"); // white
    const Image shown = settled(fitted(scene), 4);
    float apart = 0.0f;
    for (std::size_t i = 0; i < right.pixels.size(); ++i) {
        apart = std::max(apart, std::abs(right.pixels[i] - shown.pixels[i]));
    }
    EXPECT_LT(apart, 1.5 * meanOf(right)); // 2.3 times where lamps are mirrored
}

TEST_F(FittedEnvironmentTest, ModelsThatWantAKeyLight_AndNoOthers_AreLitByOneLight) {
    for (const Block* model : catalog->ofKind(kinds::models)) {
        const Scene scene = fitted(ball(model->id));
        const EffectSet set = effectSet(scene.objects[0].material, scene, *catalog);
        EXPECT_EQ(set.method == EnvironmentMethod::OneLight, model->lighting == LightsWanted::Key)
            << model->id;
    }
}

TEST_F(FittedEnvironmentTest, ModelThatDrawsMarks_IsLitFromWhereMostLightComes) {
    size_ = 65;
    image_.reset();
    Image panorama = plain(0.1f, {64, 32});
    panorama.pixels[std::size_t(16) * 64 + 48] = 1000.0f; // at +x
    Scene scene = fitted(surrounded("halftone", panorama));
    scene.objects[0].mesh = "builtin:sphere";
    EXPECT_EQ(effectSet(scene.objects[0].material, scene, *catalog).method,
              EnvironmentMethod::OneLight);
    const Image image = settled(scene, 4);
    double left = 0.0;
    double right = 0.0;
    for (int y = 24; y < 40; ++y) {
        for (int x = 0; x < 8; ++x) {
            left += pixel(image, 20 + x, y).g;
            right += pixel(image, 38 + x, y).g;
        }
    }
    EXPECT_GT(right, left);
}

/// The cosine takes two thirds of what is linear in the direction and a quarter of what is square.
TEST(EnvironmentHarmonics, OfSkiesOfEachOrder_AreThoseOfTheirIntegrals) {
    constexpr glm::ivec2 size(128, 64);
    std::vector<glm::vec4> radiance;
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const double down = std::numbers::pi * (y + 0.5) / size.y;
            const double across = 2.0 * std::numbers::pi * ((x + 0.5) / size.x - 0.5);
            const glm::vec3 d(std::sin(down) * std::sin(across), std::cos(down),
                              -std::sin(down) * std::cos(across));
            radiance.emplace_back(2.0f + d.y, 3.0f + d.x * d.y, 1.0f + d.z * d.z, 1.0f);
        }
    }
    const auto harmonics = irradianceHarmonics(size, radiance);
    EXPECT_NEAR(harmonics[0].r, 2.0f, 2e-3f);
    EXPECT_NEAR(harmonics[1].r, 2.0f / 3.0f, 2e-3f);
    EXPECT_NEAR(harmonics[4].g, 0.25f, 2e-3f);
    EXPECT_NEAR(harmonics[0].b, 4.0f / 3.0f, 2e-3f);
    EXPECT_NEAR(harmonics[6].b, 0.25f / 3.0f, 2e-3f);
    EXPECT_NEAR(harmonics[3].r, 0.0f, 1e-4f);
}

} // namespace
} // namespace patina::fitted_environment_test
