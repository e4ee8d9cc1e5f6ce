// SPDX-License-Identifier: GPL-3.0-or-later
// The light of a whole environment against theory, and against itself with many more samples.
#include <cmath>
#include <numbers>

#include "environment_fixture.h"
#include "gl/framebuffer.h"
#include "render/lights/environment_table.h"
#include "support/long_form.h"

namespace patina::environment_test {
namespace {

TEST_F(EnvironmentTest, WhiteSurfaceUnderAWhiteSky_IsWhite) {
    Scene scene = surrounded("lambert", plain(1.0f));
    makeWhite(scene);
    const Image image = settled(scene, 1024);
    for (const int x : {10, 16, 22}) {
        EXPECT_NEAR(pixel(image, x, 16).r, 1.0f, 0.005f) << x;
    }
}

TEST_F(EnvironmentTest, OneBrightTexel_LightsAsItsSolidAngleSays) {
    constexpr glm::ivec2 size(64, 32);
    Image panorama = plain(0.0f, size);
    // Straight behind the camera, which looks along -z: at +z, on the horizon.
    const int row = size.y / 2;
    panorama.pixels[std::size_t(row) * std::size_t(size.x)] = 1000.0f;
    Scene scene = surrounded("lambert", panorama);
    makeWhite(scene);
    const float middleOfIt = pixel(settled(scene, 4096), 16, 16).r;
    // Linear between texels, so the light of all of it is that of a texel: a mean over directions
    // of (1 / pi) radiance cos(theta) with the texel's own height above the horizon.
    const double width = 2.0 * std::numbers::pi / size.x;
    const double height = std::numbers::pi / size.y;
    EXPECT_NEAR(middleOfIt, 1000.0 * width * height / std::numbers::pi, 0.02 * middleOfIt);
}

TEST_F(EnvironmentTest, Rotation_TurnsCounterClockwiseSeenFromAbove) {
    constexpr glm::ivec2 size(64, 32);
    Image panorama = plain(0.0f, size);
    panorama.pixels[std::size_t(size.y / 2) * std::size_t(size.x)] = 1000.0f; // at +z
    Scene scene = surrounded("lambert", panorama);
    makeWhite(scene);
    scene.objects[0].mesh = "builtin:sphere";
    scene.part(kinds::environment)->parameters["rotate"] = 90.0; // to +x, the right of the picture
    const Image image = settled(scene, 64);
    EXPECT_GT(pixel(image, 24, 16).r, 0.1f);
    EXPECT_LT(pixel(image, 8, 16).r, 1e-3f);
}

TEST_F(EnvironmentTest, WithoutItsPicture_IsBlack) {
    const Scene scene = surrounded("lambert", plain(1.0f));
    image_.reset();
    EXPECT_EQ(pixel(settled(scene, 4), 16, 16), glm::vec3(0.0f));
}

TEST_F(EnvironmentTest, PictureWithDamagedNumbers_GivesFiniteLight) {
    Image panorama = plain(1.0f);
    panorama.pixels[5] = std::nanf("");
    panorama.pixels[6] = -3.0f;
    panorama.pixels[7] = INFINITY;
    const Scene scene = surrounded("cook-torrance", panorama);
    for (const float value : settled(scene, 64).pixels) {
        ASSERT_TRUE(std::isfinite(value) && value >= 0.0f);
    }
}

TEST_F(EnvironmentTest, HiddenBackground_IsTheScenesColour) {
    const Scene scene = surrounded("lambert", plain(1.0f));
    EXPECT_NEAR(pixel(settled(scene, 4), 0, 0).r, 0.25f, 1e-3f);
}

TEST_F(EnvironmentTest, SharpBackground_IsWhatLiesThere) {
    Image panorama = plain(0.0f, {64, 32});
    for (std::size_t y = 0; y < 16; ++y) {
        std::fill_n(panorama.pixels.begin() + std::ptrdiff_t(y) * 64, 64, 2.0f);
    }
    Scene scene = surrounded("lambert", panorama);
    scene.part(kinds::environment)->parameters["background"] = std::string("sharp");
    const Image image = settled(scene, 64);
    EXPECT_NEAR(pixel(image, 0, 0).r, 2.0f, 0.01f);
    EXPECT_NEAR(pixel(image, 0, 32).r, 0.0f, 0.01f);
}

TEST_F(EnvironmentTest, BlurredBackground_IsSmoothAcrossAnEdge) {
    Image panorama = plain(0.0f, {64, 32});
    for (std::size_t y = 0; y < 16; ++y) {
        std::fill_n(panorama.pixels.begin() + std::ptrdiff_t(y) * 64, 64, 2.0f);
    }
    Scene scene = surrounded("lambert", panorama);
    scene.part(kinds::environment)->parameters["background"] = std::string("blurred");
    scene.part(kinds::environment)->parameters["background.blur"] = 60.0;
    const Image image = settled(scene, 1024);
    EXPECT_GT(pixel(image, 0, 0).r, pixel(image, 0, 16).r + 0.1f);
    EXPECT_NEAR(pixel(image, 0, 16).r, 1.0f, 0.1f);
}

/// Preetham et al. 1999: at turbidity 3 with the sun at 45 degrees the zenith has 7.323 kcd/m^2.
TEST_F(EnvironmentTest, SkyAtItsZenith_HasTheLuminanceOfThePaper) {
    Scene scene = simpleScene();
    scene.objects.clear();
    scene.lights.clear();
    scene.camera.pitch = -90.0; // from below
    scene.setPart(kinds::environment, block("environment", "sky"));
    Values& sky = scene.part(kinds::environment)->parameters;
    sky["sun.height"] = 45.0;
    sky["sun.intensity"] = 0.0;
    sky["turbidity"] = 3.0;
    sky["background"] = std::string("sharp");
    const glm::vec3 zenith = pixel(settled(scene, 1), 16, 16);
    const float luminance = glm::dot(zenith, glm::vec3(0.2126f, 0.7152f, 0.0722f));
    EXPECT_NEAR(luminance, 0.7323f, 2e-3f);
    EXPECT_GT(zenith.b, zenith.r);
}

TEST_F(EnvironmentTest, SunOfAnySize_GivesTheSameLight) {
    size_ = 9;
    Scene scene = square("lambert");
    makeWhite(scene);
    scene.setPart(kinds::environment, block("environment", "sky"));
    Values& sky = scene.part(kinds::environment)->parameters;
    sky["sun.height"] = 0.0; // the square faces it
    sky["sun.azimuth"] = 0.0;
    sky["sun.color"] = glm::dvec3(1.0);
    const auto light = [&](double intensity, double radius) {
        sky["sun.intensity"] = intensity;
        sky["sun.size"] = radius;
        float sum = 0.0f;
        const Image image = settled(scene, 1024);
        for (int i = 0; i < 9; ++i) {
            sum += pixel(image, 3 + i % 3, 3 + i / 3).g / 9.0f;
        }
        return sum;
    };
    const float skyAlone = light(0.0, 5.0);
    for (const double radius : {1.5, 5.0, 12.0}) { // half of the disc is below the horizon
        EXPECT_NEAR(light(4.0, radius) - skyAlone, 2.0f, 0.15f) << radius;
    }
}

TEST_F(EnvironmentTest, GroundOfTheSky_IsAboutAsBrightAsWhatItReceives) {
    Scene scene = square("lambert");
    makeWhite(scene);
    scene.objects[0].mesh = "builtin:plane"; // faces up
    scene.camera.pitch = 90.0;
    scene.camera.distance = 10.0;
    scene.setPart(kinds::environment, block("environment", "sky"));
    Values& sky = scene.part(kinds::environment)->parameters;
    sky["sun.intensity"] = 0.0;
    sky["ground.color"] = glm::dvec3(1.0);
    sky["background"] = std::string("sharp");
    for (const double height : {10.0, 35.0, 60.0, 90.0}) {
        sky["sun.height"] = height;
        const Image image = settled(scene, 1024);
        const glm::vec3 received = middle(image);
        const glm::vec3 ground = pixel(image, 0, 0);
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(ground[i] / received[i], 1.0f, 0.25f) << height << ' ' << i;
        }
    }
}

/// Every number at each end of its range, by itself and all of them together.
TEST_F(EnvironmentTest, EveryBlockAtItsLimits_GivesFiniteLight) {
    size_ = 9;
    image_ = EnvironmentImage::from(plain(1.0f));
    for (const Block* environment : catalog->ofKind("environment")) {
        Scene scene = square("lambert");
        scene.objects[0].mesh = "builtin:sphere";
        scene.setPart(kinds::environment, block("environment", environment->id));
        Values& values = scene.part(kinds::environment)->parameters;
        values["background"] = std::string("sharp");
        const Values start = values;
        const auto expectFinite = [&](const std::string& what) {
            for (const float number : settled(scene, 4).pixels) {
                ASSERT_TRUE(std::isfinite(number) && number >= 0.0f) << what;
            }
        };
        Values lowest = start;
        Values highest = start;
        for (const Parameter& parameter : environment->parameters) {
            if (parameter.id == "directions" || !hasLimits(parameter)) {
                continue;
            }
            for (Values* changed : {&lowest, &highest}) {
                const double number = changed == &lowest ? parameter.min : parameter.max;
                (*changed)[parameter.id] = allOf(parameter, number);
                values = start;
                values[parameter.id] = allOf(parameter, number);
                expectFinite(environment->id + ": " + parameter.id);
            }
        }
        for (const Values& together : {lowest, highest}) {
            values = together;
            expectFinite(environment->id);
        }
    }
}

TEST_F(EnvironmentTest, FurtherFrames_AddSamplesUntilTheSceneChanges) {
    const Scene scene = inTheStudio("cook-torrance");
    View view = viewWith(scene, 8);
    ASSERT_TRUE(renderer->capture(scene, view, squares(), false));
    EXPECT_EQ(renderer->job().environmentSamples(), 8);
    const gl::Texture color = gl::Texture::create(view.size, 0x8058, 0x1908, 0x1401);
    gl::Framebuffer target = gl::Framebuffer::create();
    target.attachColor(color);
    view.isContinued = true;
    drawInWindow(scene, view, squares(), target.name());
    EXPECT_EQ(renderer->job().environmentSamples(), 16);
    view.isContinued = false;
    drawInWindow(scene, view, squares(), target.name());
    EXPECT_EQ(renderer->job().environmentSamples(), 8);
}

TEST_F(EnvironmentTest, SamplesInManyFrames_AreThoseOfOne) {
    const Scene scene = inTheStudio("cook-torrance");
    const Image atOnce = settled(scene, 64);
    View view = viewWith(scene, 16);
    const gl::Texture color = gl::Texture::create(view.size, 0x8058, 0x1908, 0x1401);
    gl::Framebuffer target = gl::Framebuffer::create();
    target.attachColor(color);
    for (int i = 0; i < 4; ++i) {
        view.isContinued = i > 0;
        drawInWindow(scene, view, squares(), target.name());
    }
    view.isContinued = true;
    const auto inSteps = renderer->capture(scene, view, squares(), false);
    ASSERT_TRUE(inSteps);
    EXPECT_EQ(renderer->job().environmentSamples(), 64);
    EXPECT_NEAR(middle(*inSteps).g, middle(atOnce).g, 2e-3f * middle(atOnce).g);
}

/// Mean of green in the middle of a picture.
double meanInTheMiddle(const Image& image) {
    const int from = 3 * image.width / 8;
    const int to = 5 * image.width / 8;
    double sum = 0.0;
    for (int y = from; y < to; ++y) {
        for (int x = from; x < to; ++x) {
            const std::size_t at = std::size_t(y) * std::size_t(image.width) + std::size_t(x);
            sum += image.pixels[at * std::size_t(image.channels) + 1];
        }
    }
    return sum / double((to - from) * (to - from));
}

TEST_F(EnvironmentTest, LessThanARound_IsRightOnAverage) {
    size_ = 128;
    const Scene scene = inTheStudio("lambert");
    const double right = meanInTheMiddle(settled(scene, 256));
    for (const int samples : {1, 2, 3}) {
        const double mean = meanInTheMiddle(settled(scene, samples));
        EXPECT_EQ(renderer->job().environmentSamples(), samples);
        EXPECT_NEAR(mean, right, 0.1 * right) << samples;
    }
}

TEST_F(EnvironmentTest, WithoutOne_ThereAreNoSamples) {
    const Scene scene = simpleScene();
    ASSERT_TRUE(renderer->capture(scene, viewWith(scene, 8), squares(), false));
    EXPECT_EQ(renderer->job().environmentSamples(), 0);
}

/// A model with values that make it matte, glossy or sharp, and how far it is turned away.
struct Look {
    std::string name;
    std::string model;
    Values values;
    double turned = 20.0;
};

class SettlingTest : public EnvironmentTest, public testing::WithParamInterface<Look> {};

/// Root of the mean squared difference in the middle of the picture, as a share of the mean there.
double differenceInTheMiddle(const Image& a, const Image& b) {
    double squares = 0.0;
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double away = std::hypot(x - a.width / 2, y - a.height / 2);
            if (away > 0.25 * a.width) {
                continue;
            }
            const std::size_t at = 4 * (std::size_t(y) * std::size_t(a.width) + std::size_t(x)) + 1;
            const double apart = double(a.pixels[at]) - double(b.pixels[at]);
            squares += apart * apart;
            sum += b.pixels[at];
            ++count;
        }
    }
    return std::sqrt(squares / count) / (sum / count);
}

TEST_P(SettlingTest, With4096Samples_IsWithinOnePerCentOfManyMore) {
    const int manyMore = tests::casesOf(1 << 18, 1 << 20);
    size_ = 5;
    Scene scene = inTheStudio(GetParam().model);
    for (const auto& [id, value] : GetParam().values) {
        scene.objects[0].material.model.parameters[id] = value;
    }
    // Turned, so that the edge of a lamp is seen in it.
    scene.objects[0].rotation = {-15.0, GetParam().turned, 0.0};
    const Image after4096 = settled(scene, 4096);
    EXPECT_LT(differenceInTheMiddle(after4096, settled(scene, manyMore)), 0.01);
}

INSTANTIATE_TEST_SUITE_P(
    Models, SettlingTest,
    testing::Values(
        Look{"Matte", "lambert", {}}, Look{"Glossy", "cook-torrance", {{"roughness", 0.2}}},
        Look{"Sharp",
             "phong",
             {{"shininess", 20000.0},
              {"normalisation", std::string("normalised")},
              {"diffuse.color", glm::dvec3(0.0)}}},
        Look{"Brushed", "ward", {{"roughness.x", 0.05}, {"roughness.y", 0.4}}},
        Look{"BrushedFinely", "ward", {{"roughness.x", 0.01}, {"roughness.y", 0.3}}, 50.0},
        Look{"SeenFlat", "ashikhmin-shirley", {{"shininess.x", 1000.0}}, 60.0}),
    [](const auto& instance) { return instance.param.name; });

TEST(EnvironmentTableTest, Densities_AreOneOnAverage) {
    EnvironmentTable table;
    std::vector<glm::vec4> light(8 * 4, glm::vec4(0.1f));
    light[13] = glm::vec4(500.0f);
    table.build({8, 4}, light);
    double sum = 0.0;
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 8; ++column) {
            sum += table.texels()[row * 8 + column].y;
        }
    }
    EXPECT_NEAR(sum / 32.0, 1.0, 1e-6);
}

/// Light from a square of directions about the zenith reflects as the cosine's integral says.
TEST(EnvironmentTableTest, Upward_IsTheShareOfTheSkyThatALevelSurfaceSees) {
    constexpr glm::ivec2 size(32, 16);
    std::vector<glm::vec4> light(std::size_t(size.x) * std::size_t(size.y), glm::vec4(0.0f));
    EnvironmentTable table;
    table.build(size, std::vector<glm::vec4>(light.size(), glm::vec4(3.0f)));
    EXPECT_NEAR(table.upward().g, 3.0, 1e-6);
    for (std::size_t i = 0; i < std::size_t(4 * size.x); ++i) { // down to 45 degrees
        light[i] = glm::vec4(2.0f);
    }
    table.build(size, light);
    EXPECT_NEAR(table.upward().g, 1.0, 1e-6); // 2 sin^2 of 45 degrees
}

TEST(EnvironmentTableTest, Upward_SeesNothingOfWhatIsBelow) {
    constexpr glm::ivec2 size(8, 4);
    std::vector<glm::vec4> light(32, glm::vec4(0.0f));
    std::fill(light.begin() + 16, light.end(), glm::vec4(5.0f));
    EnvironmentTable table;
    table.build(size, light);
    EXPECT_NEAR(table.upward().g, 0.0, 1e-9);
}

TEST(EnvironmentImageTest, Missing_GivesLightAndLooksLikeNoPlace) {
    const auto image = EnvironmentImage::missing();
    const EnvironmentTexels& texels = image->whole;
    ASSERT_EQ(texels.halves.size(), std::size_t(4 * texels.size.x * texels.size.y));
    EXPECT_GT(texels.halves[0], texels.halves[1]); // red and blue without green
    EXPECT_GT(texels.halves[2], texels.halves[1]);
}

TEST(EnvironmentTableTest, NoLight_DrawsAllDirectionsEvenly) {
    EnvironmentTable table;
    table.build({8, 4}, std::vector<glm::vec4>(32, glm::vec4(0.0f)));
    EXPECT_NEAR(table.texels()[3].x, 0.5, 1e-6);
    EXPECT_NEAR(table.texels()[4 * 8 + 1].x, 0.5, 1e-6);
}

} // namespace
} // namespace patina::environment_test
