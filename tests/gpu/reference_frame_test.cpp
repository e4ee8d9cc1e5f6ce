// SPDX-License-Identifier: GPL-3.0-or-later
// Frames computed twice: by the device in floats, by the CPU in double precision.
#include "measure/error/reference_frame.h"

#include <algorithm>
#include <cmath>

#include "core/exposure.h"
#include "core/mesh_openness.h"
#include "gpu_fixture.h"
#include "measure/error/frame_error.h"
#include "render/lights/environment_light.h"
#include "render/surfaces/surface_buffer_drawer.h"

namespace patina::reference_frame_test {
namespace {

class ReferenceFrameTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    View wholeView(const Scene& scene) const {
        View view = viewOf(scene, 48);
        view.samples = 1;
        view.numbers = HdrNumbers::Full;
        view.environmentSamples = directions_;
        view.environmentImage = EnvironmentImage::missing();
        return view;
    }

    Result<std::unique_ptr<ReferenceFrame>> reference(const Scene& scene) {
        auto buffer = renderer->surfaces().capture(scene, wholeView(scene), meshSource());
        EXPECT_TRUE(buffer) << (buffer ? "" : buffer.error().text());
        return ReferenceFrame::create(std::move(*buffer),
                                      std::vector<bool>(scene.objects.size(), true));
    }

    /// Draws all directions of an environment that the device draws.
    void finish(ReferenceFrame& frame, const Scene& scene) {
        for (int round = 1; round <= directions_ / EnvironmentLight::roundSamples; ++round) {
            while (!frame.step(std::chrono::milliseconds(10))) {
            }
            if (round < directions_ / EnvironmentLight::roundSamples) {
                frame.goOn(
                    *renderer->surfaces().capture(scene, wholeView(scene), meshSource(), round));
            }
        }
    }

    int directions_ = EnvironmentLight::roundSamples;

    /// Compares the device's frame with the one in double precision.
    FrameError error(const Scene& scene) {
        auto right = reference(scene);
        EXPECT_TRUE(right) << (right ? "" : right.error().text());
        finish(**right, scene);
        const auto image = renderer->capture(scene, wholeView(scene), meshSource(), false);
        EXPECT_TRUE(image);
        LinearFrame frame;
        const double factor = exposureFactor(scene.exposure);
        for (std::size_t i = 0; i + 3 < image->pixels.size(); i += 4) {
            frame.colors.push_back(
                glm::dvec3(image->pixels[i], image->pixels[i + 1], image->pixels[i + 2]) / factor);
        }
        const FrameError found =
            ErrorMeter((*right)->frame(), DisplayCurve::of(scene, *catalog)).errorOf(frame);
        EXPECT_GT(found.pixels, 300u);
        return found;
    }
};

/// What is left is the rounding of floats.
constexpr double rounding = 1e-4;

/// How the surface bends is not known in double precision, which is said.
TEST_F(ReferenceFrameTest, EveryModel_DiffersByRoundingOnlyOrIsRefused) {
    for (const Block* model : catalog->ofKind("models")) {
        SCOPED_TRACE(model->id);
        Scene scene = simpleScene(model->id);
        scene.lights.push_back(light("point"));
        scene.ambient = {0.1, 0.2, 0.3};
        if (model->withRole(roles::placeCurvature) != nullptr) {
            EXPECT_FALSE(reference(scene));
        } else {
            EXPECT_LE(error(scene).p99, rounding);
        }
    }
}

/// One whose diffuse term depends on the highlight, one with a highlight in its slot, one without
/// terms.
TEST_F(ReferenceFrameTest, LightsInSeparateColours_DifferByRoundingOnly) {
    for (const char* model : {"ashikhmin-shirley", "lambert", "strauss"}) {
        SCOPED_TRACE(model);
        Scene scene = simpleScene(model);
        scene.lights.push_back(light("point"));
        for (Light& each : scene.lights) {
            each.block.parameters["color.diffuse"] = glm::dvec3(1.0, 0.5, 0.25);
            each.block.parameters["color.highlight"] = glm::dvec3(0.25, 0.5, 2.0);
            each.block.parameters["color.ambient"] = glm::dvec3(0.1, 0.2, 0.3);
        }
        if (catalog->find("models", model)->slot("specular") != nullptr) {
            BlockValues highlight = block("specular", "phong");
            highlight.parameters["ambient.color"] = glm::dvec3(0.3, 0.2, 0.1);
            scene.objects[0].material.parts["specular"] = highlight;
        }
        EXPECT_LE(error(scene).p99, rounding);
    }
}

/// Every term in the model that is quicker to compile, and one in the waves' own sum; in part and
/// whole.
TEST_F(ReferenceFrameTest, PolarisedLights_DifferByRoundingOnly) {
    std::vector<std::pair<const char*, std::string>> pairs{{"he-torrance", "dielectric"}};
    for (const Block* fresnel : catalog->ofKind("fresnel")) {
        pairs.emplace_back("cook-torrance", fresnel->id);
    }
    for (const auto& [model, fresnel] : pairs) {
        SCOPED_TRACE(fresnel + ' ' + model);
        Scene ordinary = simpleScene(model);
        ordinary.ambient = {0.1, 0.2, 0.3};
        ordinary.lights.push_back(light("point"));
        ordinary.objects[0].material.parts["fresnel"] = block("fresnel", fresnel);
        Scene scene = ordinary;
        scene.lights[0].block.parameters["polarised"] = 1.0;
        scene.lights[0].block.parameters["polarised.direction"] = glm::dvec3(1.0, 0.3, 0.0);
        scene.lights[1].block.parameters["polarised"] = 0.4;
        scene.lights[1].block.parameters["color.highlight"] = glm::dvec3(0.25, 0.5, 2.0);
        const double found = error(scene).p99;
        EXPECT_LE(found, found <= rounding ? rounding : 2.0 * error(ordinary).p99);
    }
}

TEST_F(ReferenceFrameTest, PolarisedLightThroughAFilter_DiffersByRoundingOnly) {
    for (const std::string filter : {"s", "p"}) {
        Scene scene = simpleScene("cook-torrance");
        scene.objects[0].material.parts["fresnel"] = block("fresnel", "dielectric");
        scene.objects[0].material.parts["fresnel"].parameters["polarisation"] = filter;
        const Image ordinary = capture(scene);
        scene.lights[0].block.parameters["polarised"] = 1.0;
        EXPECT_NE(capture(scene), ordinary);
        EXPECT_LE(error(scene).p99, rounding);
    }
}

TEST_F(ReferenceFrameTest, FresnelOverTheSum_IsBlended) {
    Scene scene = simpleScene();
    scene.objects[0].material.parts["fresnel"] = block("fresnel", "dielectric");
    EXPECT_LE(error(scene).p99, rounding);
}

TEST_F(ReferenceFrameTest, GlowUnderAFresnelTerm_IsNotBlended) {
    Scene scene = simpleScene();
    scene.objects[0].material.parts["fresnel"] = block("fresnel", "dielectric");
    scene.objects[0].material.model.parameters["emissive.color"] = glm::dvec3(0.5, 0.2, 0.1);
    EXPECT_LE(error(scene).p99, rounding);
}

/// Gives a fog values with which it can be seen at the ball.
BlockValues seenFog(BlockValues fog) {
    if (fog.parameters.contains("start")) {
        fog.parameters["start"] = 0.5;
        fog.parameters["end"] = 9.0;
    }
    return fog;
}

TEST_F(ReferenceFrameTest, EveryFog_IsInIt) {
    const Image clear = capture(simpleScene());
    for (const Block* fog : catalog->ofKind("fog")) {
        SCOPED_TRACE(fog->id);
        Scene scene = simpleScene();
        scene.setPart(kinds::fog, seenFog(block("fog", fog->id)));
        EXPECT_GT(glm::distance(middle(capture(scene)), middle(clear)), 0.01f);
        EXPECT_LE(error(scene).p99, rounding);
    }
}

/// Returns another value that every field of a fog may take.
Value moved(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return *number + 0.25;
    }
    return std::get<glm::dvec3>(value) * 0.75 + glm::dvec3(0.1, 0.05, 0.2);
}

double maxDifference(const Image& a, const Image& b) {
    double difference = 0.0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        difference = std::max(difference, std::abs(double(a.pixels[i]) - b.pixels.at(i)));
    }
    return difference;
}

TEST_F(ReferenceFrameTest, EachFieldOfEveryFog_ChangesTheFrameAsItDoesInDouble) {
    for (const Block* fog : catalog->ofKind("fog")) {
        Scene scene = simpleScene();
        scene.camera.pitch = 10.0;
        scene.setPart(kinds::fog, seenFog(block("fog", fog->id)));
        const Image before = capture(scene);
        for (const Parameter& field : fog->parameters) {
            SCOPED_TRACE(fog->id + "." + field.id);
            Scene changed = scene;
            Value& value = changed.part(kinds::fog)->parameters[field.id];
            value = moved(value);
            EXPECT_GT(maxDifference(capture(changed), before), 0.005);
            EXPECT_LE(error(changed).p99, rounding);
        }
    }
}

/// The camera looks from above and from within the box, past its edges.
TEST_F(ReferenceFrameTest, FogThatEndsSomewhere_IsInIt) {
    for (const double pitch : {-20.0, 0.0, 35.0}) {
        SCOPED_TRACE(pitch);
        Scene scene = simpleScene();
        scene.camera.pitch = pitch;
        scene.setPart(kinds::fog, block("fog", "height"));
        EXPECT_LE(error(scene).p99, rounding);
        scene.setPart(kinds::fog, block("fog", "box"));
        scene.part(kinds::fog)->parameters["size"] = glm::dvec3(1.2, 0.7, 4.0);
        scene.part(kinds::fog)->parameters["center"] = glm::dvec3(0.3, 0.2, 1.0);
        EXPECT_LE(error(scene).p99, rounding);
    }
}

TEST_F(ReferenceFrameTest, Hemisphere_IsInIt) {
    Scene scene = simpleScene();
    scene.hemisphere.sky = {0.2, 0.4, 0.9};
    scene.hemisphere.ground = {0.3, 0.1, 0.0};
    scene.hemisphere.up = {0.2, 1.0, 0.1};
    EXPECT_LE(error(scene).p99, rounding);
}

/// A ring is lit with and without an environment; its inner side hides light from itself.
TEST_F(ReferenceFrameTest, Occlusion_IsInIt) {
    Scene scene = simpleScene("phong");
    scene.objects[0].mesh = "builtin:torus";
    scene.objects[0].rotation = {60.0, 0.0, 0.0};
    scene.ambient = {0.1, 0.2, 0.3};
    scene.hemisphere = {{0.2, 0.4, 0.9}, {0.3, 0.1, 0.0}, {0.2, 1.0, 0.1}};
    const Image open = capture(scene);
    openness["torus"] = opennessOf(mesh(scene.objects[0]));
    scene.occlusion = true;
    EXPECT_NE(capture(scene), open);
    EXPECT_LE(error(scene).p99, rounding);
    scene.setPart(kinds::environment, block("environment", "studio"));
    EXPECT_LE(error(scene).p99, rounding);
}

TEST_F(ReferenceFrameTest, Exposure_ChangesNoRelativeError) {
    Scene scene = simpleScene();
    scene.exposure = 3.0;
    EXPECT_LE(error(scene).p99, rounding);
}

/// What of each light arrives is taken from the device's maps.
TEST_F(ReferenceFrameTest, Shadows_AreInIt) {
    Scene scene = simpleScene("phong");
    scene.objects.push_back(object("lambert", "cube"));
    scene.objects[1].translation = {0.4, 0.3, 1.2};
    scene.objects[1].scale = glm::dvec3(0.3);
    for (int i = 0; i < 6; ++i) {
        scene.lights.push_back(sun({0.2 * i - 0.5, -0.3, -1.0}));
        scene.lights.back().setPart(kinds::shadows, block("shadows", i % 2 == 0 ? "hard" : "soft"));
    }
    EXPECT_LE(error(scene).p99, rounding);
}

/// A checker of two colours on the diffuse one and a gradient of roughness.
TEST_F(ReferenceFrameTest, Images_AreTakenAsTheyWereSampled) {
    const auto picture = [](float first, float second) {
        FileImage image{{2, 1, 3, {first, first, first, second, second, second}}, 8};
        return std::make_shared<const TexturePicture>(madeTexture(image, TextureDecoding::Linear));
    };
    const auto wide = picture(0.2f, 0.9f);
    renderer->setTextures([&wide](const TextureUse&, TextureDecoding) {
        return TextureLookup{wide, false};
    });
    Scene scene = simpleScene("oren-nayar");
    scene.objects[0].material.textures["diffuse.color"].file = "/a.png";
    scene.objects[0].material.textures["roughness"].file = "/b.png";
    EXPECT_LE(error(scene).p99, rounding);
}

/// The device draws three rounds of directions; the CPU has them round by round.
TEST_F(ReferenceFrameTest, EnvironmentsLight_ComesFromTheSameDirections) {
    directions_ = SurfaceBufferDrawer::plainSamples;
    for (const char* model : {"lambert", "phong", "ward", "strauss", "he-torrance"}) {
        SCOPED_TRACE(model);
        Scene scene = simpleScene(model);
        scene.lights.resize(1);
        scene.setPart(kinds::environment, block("environment", "studio"));
        scene.part(kinds::environment)->parameters["rotate"] = 40.0;
        EXPECT_LE(error(scene).p99, rounding);
    }
}

/// A drawing has one light without its shadow, or the environment as one.
TEST_F(ReferenceFrameTest, DrawingsLight_IsTheSame) {
    for (const char* model : {"gooch", "toon"}) {
        SCOPED_TRACE(model);
        Scene scene = simpleScene(model);
        scene.objects.push_back(object("lambert", "cube"));
        scene.objects[1].translation = {0.4, 0.3, 1.2};
        scene.objects[1].scale = glm::dvec3(0.3);
        scene.lights = {sun({0.5, -0.3, -1.0}), light("point"), sun({-0.2, -0.3, -1.0})};
        scene.lights[2].isKey = true;
        scene.lights[2].setPart(kinds::shadows, block("shadows", "hard"));
        scene.ambient = {0.1, 0.2, 0.3};
        scene.setPart(kinds::environment, block("environment", "studio"));
        directions_ = SurfaceBufferDrawer::plainSamples;
        EXPECT_LE(error(scene).p99, rounding);
        scene.lights.clear();
        scene.objects.pop_back();
        EXPECT_LE(error(scene).p99, rounding);
    }
}

TEST_F(ReferenceFrameTest, EnvironmentsPictureAndShadows_AreInIt) {
    directions_ = SurfaceBufferDrawer::plainSamples;
    Scene scene = simpleScene("cook-torrance");
    scene.setPart(kinds::environment, block("environment", "image"));
    scene.lights.front().setPart(kinds::shadows, block("shadows", "hard"));
    scene.objects[0].material.parts["fresnel"] = block("fresnel", "dielectric");
    EXPECT_LE(error(scene).p99, rounding);
}

TEST_F(ReferenceFrameTest, WhatIsTransparent_IsRefused) {
    Scene scene = simpleScene();
    scene.objects[0].material.opacity = 0.5;
    EXPECT_FALSE(reference(scene));
}

TEST_F(ReferenceFrameTest, UnwantedObjects_DoNotCount) {
    const Scene scene = simpleScene();
    auto buffer = renderer->surfaces().capture(scene, wholeView(scene), meshSource());
    auto right = ReferenceFrame::create(std::move(*buffer), {false});
    ASSERT_TRUE(right);
    while (!(*right)->step(std::chrono::milliseconds(10))) {
    }
    const auto& counts = (*right)->frame().counts;
    EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), 0);
}

TEST_F(ReferenceFrameTest, DisplayCurve_IsTheDevices) {
    Scene scene = simpleScene();
    scene.exposure = 0.7;
    for (const Block* tone : catalog->ofKind(kinds::tone)) {
        SCOPED_TRACE(tone->id);
        scene.setPart(kinds::tone, block("tone", tone->id));
        const auto linear = renderer->capture(scene, wholeView(scene), meshSource(), false);
        const auto shown = renderer->capture(scene, wholeView(scene), meshSource(), true);
        const DisplayCurve curve = DisplayCurve::of(scene, *catalog);
        ASSERT_NE(curve.tone, nullptr);
        for (const int x : {0, 12, 24, 30}) {
            const glm::dvec3 light =
                glm::dvec3(pixel(*linear, x, 24)) / exposureFactor(scene.exposure);
            EXPECT_NEAR(curve.shown(light).r, pixel(*shown, x, 24).r, 0.51 / 255.0);
        }
    }
}

TEST(FrameError, KnownDifferences_AreCounted) {
    LinearFrame right;
    right.size = {4, 1};
    right.colors.assign(4, glm::dvec3(0.5));
    right.counts = {1, 1, 1, 0};
    LinearFrame frame = right;
    frame.colors[1] = {0.5, 0.55, 0.5};
    frame.colors[3] = glm::dvec3(9.0);
    const FrameError error = ErrorMeter(right, DisplayCurve{}).errorOf(frame);
    EXPECT_EQ(error.pixels, 3u);
    EXPECT_NEAR(error.max, 0.1, 1e-12);
    EXPECT_NEAR(error.mean, 0.1 / 3.0, 1e-12);
    EXPECT_NEAR(error.rms, 0.1 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(error.stepShare, 1.0 / 3.0, 1e-12);
}

TEST(FrameError, WhatIsNoNumber_IsInfinitelyWrong) {
    LinearFrame right;
    right.size = {1, 1};
    right.colors.assign(1, glm::dvec3(0.5));
    right.counts = {1};
    LinearFrame frame = right;
    frame.colors[0].g = std::nan("");
    EXPECT_TRUE(std::isinf(ErrorMeter(right, DisplayCurve{}).errorOf(frame).max));
}

} // namespace
} // namespace patina::reference_frame_test
