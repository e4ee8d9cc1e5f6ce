// SPDX-License-Identifier: GPL-3.0-or-later
// Images on surfaces: what a pixel shows against what the image says.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/srgb_table.h"
#include "gl/framebuffer.h"
#include "render/surfaces/inspection_drawer.h"
#include "shading/program/program_source.h"
#include "texture_fixture.h"

namespace patina::texture_test {
namespace {

TEST_F(TextureTest, Checker_ShowsItsTexelsTheRightWayUp) {
    file("checker", {2, 2}, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1});
    use("diffuse.color", "checker");
    const Image image = drawn();
    expectNear(at(image, 0.25, 0.75), {1, 0, 0}); // the file's first row is the top
    expectNear(at(image, 0.75, 0.75), {0, 1, 0});
    expectNear(at(image, 0.25, 0.25), {0, 0, 1});
    expectNear(at(image, 0.75, 0.25), {1, 1, 1});
}

TEST_F(TextureTest, EightBitColor_IsDecodedFromSrgb) {
    const SrgbTable table;
    for (const int code : {0, 10, 64, 128, 200, 255}) {
        const float value = float(code) / 255.0f;
        file("code" + std::to_string(code), {1, 1}, 3, {value, value, value}, 8);
        use("diffuse.color", "code" + std::to_string(code));
        expectNear(at(drawn(), 0.5, 0.5), glm::vec3(table.decoded(std::uint8_t(code))));
    }
}

TEST_F(TextureTest, EightBitColorSaidToBeLinear_IsTheNumberItself) {
    file("grey", {1, 1}, 3, {0.4f, 0.4f, 0.4f}, 8);
    use("diffuse.color", "grey").colorSpace = TextureColorSpace::Linear;
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.4f));
}

TEST_F(TextureTest, SquareRoots_AreSquared) {
    file("roots", {1, 1}, 3, {0.5f, 0.2f, 1.0f});
    use("diffuse.color", "roots").colorSpace = TextureColorSpace::Roots;
    expectNear(at(drawn(), 0.5, 0.5), {0.25f, 0.04f, 1.0f});
    use("diffuse.color", "roots").colorSpace = TextureColorSpace::Roots;
    use("diffuse.color", "roots").channel = TextureChannel::Green;
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.2f));
}

TEST_F(TextureTest, FloatColor_IsLinear) {
    file("float", {1, 1}, 3, {0.25f, 0.5f, 0.75f});
    use("diffuse.color", "float");
    expectNear(at(drawn(), 0.5, 0.5), {0.25f, 0.5f, 0.75f});
}

TEST_F(TextureTest, EachChannel_CountsAlone) {
    file("four", {1, 1}, 4, {0.2f, 0.4f, 0.6f, 0.8f});
    const std::array<std::pair<TextureChannel, float>, 4> channels{{{TextureChannel::Red, 0.2f},
                                                                    {TextureChannel::Green, 0.4f},
                                                                    {TextureChannel::Blue, 0.6f},
                                                                    {TextureChannel::Alpha, 0.8f}}};
    for (const auto& [channel, expected] : channels) {
        use("diffuse.color", "four").channel = channel;
        expectNear(at(drawn(), 0.5, 0.5), glm::vec3(expected));
    }
}

TEST_F(TextureTest, GreyFile_IsGreyInAllColors) {
    file("grey", {1, 1}, 1, {0.3f});
    use("diffuse.color", "grey");
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.3f));
}

TEST_F(TextureTest, Multiply_DarkensTheValue) {
    file("half", {1, 1}, 3, {0.5f, 0.25f, 1.0f});
    color({0.8, 0.4, 0.2});
    use("diffuse.color", "half").mode = TextureMode::Multiply;
    expectNear(at(drawn(), 0.5, 0.5), {0.4f, 0.1f, 0.2f});
}

TEST_F(TextureTest, Add_EndsAtTheRangeOfTheValue) {
    file("half", {1, 1}, 3, {0.5f, 0.25f, 0.0f});
    color({0.8, 0.4, 0.2});
    use("diffuse.color", "half").mode = TextureMode::Add;
    expectNear(at(drawn(), 0.5, 0.5), {1.0f, 0.65f, 0.2f});
}

TEST_F(TextureTest, Strength_IsTheImagesShare) {
    file("white", {1, 1}, 3, {1, 1, 1});
    color(glm::dvec3(0.2));
    use("diffuse.color", "white").strength = 0.25;
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.4f));
}

/// Two texels side by side, shown from u = -1 on: what lies beside the image.
std::array<float, 4> besides(TextureWrap wrap) {
    switch (wrap) {
    case TextureWrap::Clamp:
        return {0, 0, 0, 1};
    case TextureWrap::Mirror:
        return {1, 0, 0, 1};
    default:
        return {0, 1, 0, 1};
    }
}

TEST_F(TextureTest, EachWrap_ContinuesTheImageAsItSays) {
    file("pair", {2, 1}, 1, {0.0f, 1.0f});
    for (const TextureWrap wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror}) {
        TextureUse& pair = use("diffuse.color", "pair");
        pair.wrap = wrap;
        pair.scale = {2.0, 1.0};
        pair.offset = {-1.0, 0.0};
        const Image image = drawn();
        for (std::size_t i = 0; i < 4; ++i) {
            expectNear(at(image, 0.125 + 0.25 * double(i), 0.5), glm::vec3(besides(wrap)[i]));
        }
    }
}

TEST_F(TextureTest, Rotation_TurnsTheImageCounterClockwise) {
    file("corner", {2, 2}, 1, {0, 0, 0, 1}); // white at the bottom right
    use("diffuse.color", "corner").rotation = 90.0;
    const Image image = drawn();
    expectNear(at(image, 0.75, 0.75), glm::vec3(1.0f));
    expectNear(at(image, 0.75, 0.25), glm::vec3(0.0f));
}

TEST_F(TextureTest, SmoothImageFromAfar_IsTheMeanOfItsLight) {
    std::vector<float> texels;
    for (int i = 0; i < 64 * 64; ++i) {
        texels.push_back((i + i / 64) % 2 == 0 ? 1.0f : 0.0f);
    }
    file("fine", {64, 64}, 1, texels, 8);
    TextureUse& fine = use("diffuse.color", "fine");
    fine.filter = TextureFilter::Smooth;
    fine.scale = glm::dvec2(64.0);
    // Half the light is code 188, which is 0.503 when it is decoded.
    EXPECT_NEAR(at(drawn(), 0.5, 0.5).x, 0.503f, 0.003f);
}

TEST_F(TextureTest, NumbersThatAreNone_ShowAsBlack) {
    file("bad", {1, 1}, 3, {std::nanf(""), INFINITY, -INFINITY});
    use("diffuse.color", "bad");
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.0f));
}

TEST_F(TextureTest, MissingFile_IsAChecker) {
    use("diffuse.color", "missing").filter = TextureFilter::Nearest;
    const Image image = drawn(64);
    EXPECT_GT(glm::distance(at(image, 0.06, 0.06), at(image, 0.19, 0.06)), 0.5f);
}

/// It shows as on a colour: neighbouring fields of the checker look different.
TEST_F(TextureTest, MissingReliefOrOpacity_IsSeen) {
    for (const char* id : {"normal", "height", "opacity"}) {
        scene.lights.front() = sun({-0.6, 0.0, -0.8});
        scene.objects.front().material.textures.clear();
        const Image plain = drawn(64);
        use(id, "missing").filter = TextureFilter::Nearest;
        const Image image = drawn(64);
        float largest = 0.0f;
        for (int x = 0; x < image.width; ++x) {
            largest = std::max(largest, glm::distance(pixel(image, x, 4), pixel(plain, x, 4)));
        }
        EXPECT_GT(largest, 0.1f) << id;
    }
}

/// Half of the surface is still there.
TEST_F(TextureTest, MissingCutOut_LeavesHalfOfTheFields) {
    const Image plain = drawn(64);
    TextureUse& missing = use("opacity", "missing");
    missing.filter = TextureFilter::Nearest;
    missing.cutOut = true;
    const Image image = drawn(64);
    int same = 0;
    for (int i = 0; i < 64 * 64; ++i) {
        const bool isSame = pixel(image, i % 64, i / 64) == pixel(plain, i % 64, i / 64);
        same += isSame ? 1 : 0;
    }
    EXPECT_NEAR(same, 0.5 * 64 * 64, 64.0 * 64.0 / 16.0);
}

TEST_F(TextureTest, FileThatIsOnItsWay_ShowsTheValue) {
    use("diffuse.color", "not here yet");
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.5f));
}

TEST_F(TextureTest, FlatNormalMap_ChangesNothing) {
    file("flat", {1, 1}, 3, {0.5f, 0.5f, 1.0f});
    use("normal", "flat");
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.5f));
}

/// The light comes from the right and above the surface.
TEST_F(TextureTest, NormalMap_TiltsRedToTheRightAndGreenUp) {
    const double tilt = 0.6;
    const double rest = 0.8;
    file("right", {1, 1}, 3, {float(0.5 + 0.5 * tilt), 0.5f, float(0.5 + 0.5 * rest)});
    file("up", {1, 1}, 3, {0.5f, float(0.5 + 0.5 * tilt), float(0.5 + 0.5 * rest)});
    color(glm::dvec3(1.0));
    scene.lights.front() = sun({-tilt, 0.0, -rest});
    scene.lights.front().block.parameters["intensity"] = double(brightness);
    use("normal", "right");
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(1.0f)); // straight at the light
    use("normal", "up");
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(float(rest * rest)));
}

class HeightTest : public TextureTest {
  protected:
    /// White, with heights that rise by `strength` from left to right.
    void useRamp(double strength) {
        std::vector<float> ramp;
        for (int i = 0; i < 256; ++i) {
            ramp.push_back((float(i) + 0.5f) / 256.0f);
        }
        file("ramp", {256, 1}, 1, ramp);
        color(glm::dvec3(1.0));
        TextureUse& height = use("height", "ramp");
        height.filter = TextureFilter::Smooth;
        height.strength = strength;
    }
};

/// A ramp that rises by 1 over a quad that is 2 wide has a slope of 1/2.
TEST_F(HeightTest, Ramp_HasTheNormalOfItsSlope) {
    useRamp(1.0);
    // n = (-1/2, 0, 1) / |...|, so n.l = 1 / sqrt(1.25). Texels are blended in steps of 1/256.
    EXPECT_NEAR(at(drawn(64), 0.4, 0.5).x, 1.0 / std::sqrt(1.25), 0.01);
}

/// A square from -1 to 1 of many triangles that share their corners.
Mesh finePlane() {
    constexpr unsigned cells = 9;
    constexpr unsigned row = cells + 1;
    Mesh mesh;
    for (unsigned i = 0; i < row * row; ++i) {
        const glm::vec2 at = glm::vec2(i % row, i / row) / float(cells);
        mesh.vertices.push_back({glm::vec3(2.0f * at - 1.0f, 0.0f), {0, 0, 1}, {1, 0, 0, 1}, at});
    }
    for (unsigned y = 0; y < cells; ++y) {
        for (unsigned i = y * row; i < y * row + cells; ++i) {
            mesh.indices.insert(mesh.indices.end(),
                                {i, i + 1, i + row + 1, i, i + row + 1, i + row});
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

/// At the edges of triangles, which lie in the middle of pixels, samples belong to two of them.
TEST_F(HeightTest, OnAFineMesh_AreAsEvenWithFourSamplesAsWithOne) {
    useRamp(4.0);
    const Mesh mesh = finePlane();
    constexpr int size = 64;
    constexpr int rim = 4; // beside it the image begins again
    const auto drawn = [&](int samples) {
        View view = viewOf(scene, size);
        view.samples = samples;
        return renderer
            ->capture(
                scene, view, [&mesh](const Object&) { return mesh.view(); }, false)
            .value();
    };
    const Image one = drawn(1);
    const Image four = drawn(4);
    double worst = 0.0;
    for (int y = rim; y < size - rim; ++y) {
        for (int x = rim; x < size - rim; ++x) {
            worst = std::max(worst, std::abs(double(pixel(one, x, y).x - pixel(four, x, y).x)));
        }
    }
    EXPECT_LT(worst, 0.02 * brightness); // heights are rounded to half floats
}

TEST_F(TextureTest, OneFileInTwoMaterials_IsOneTexture) {
    file("float", {1, 1}, 3, {0.25f, 0.5f, 0.75f});
    use("diffuse.color", "float");
    scene.objects.push_back(scene.objects.front());
    drawn();
    EXPECT_EQ(pictures.size(), 1u);
}

TEST_F(TextureTest, LargeImageInAWindow_ComesOverSeveralFrames) {
    file("large", {2048, 2048}, 1, std::vector<float>(2048 * 2048, 0.25f));
    use("diffuse.color", "large");
    const gl::Texture color = gl::Texture::create({8, 8}, 0x8058 /* GL_RGBA8 */,
                                                  0x1908 /* GL_RGBA */, 0x1401 /* bytes */);
    gl::Framebuffer target = gl::Framebuffer::create();
    target.attachColor(color);
    const auto mesh = [this](const Object&) { return quad(); };
    const auto draw = [&] {
        if (!drawInWindow(scene, viewOf(scene, 8), mesh, target.name())) {
            while (!proceed(std::chrono::milliseconds(100))) {
            }
            renderer->job().show(target.name());
        }
    };
    int frames = 0;
    do {
        draw();
        ++frames;
    } while (renderer->report().isWaiting && frames < 10);
    EXPECT_EQ(frames, 3); // 16 MiB and a third, 8 MiB each
    expectNear(at(drawn(), 0.5, 0.5), glm::vec3(0.25f));
}

TEST_F(TextureTest, Inspection_FindsNothingWrong) {
    file("float", {1, 1}, 3, {0.25f, 0.5f, 0.75f});
    use("diffuse.color", "float");
    use("normal", "float");
    const auto image = renderer->inspection().capture(
        scene, viewOf(scene, 8), [this](const Object&) { return quad(); }, false);
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_EQ(middle(*image).y, 0.0f);
}

/// Returns the largest difference between a pixel and the mean of those on its left and right, in
/// the middle of the picture.
float largestSpeck(const Image& image) {
    float largest = 0.0f;
    for (int y = image.height / 4; y < 3 * image.height / 4; ++y) {
        for (int x = image.width / 4; x < 3 * image.width / 4; ++x) {
            const auto at = [&](int i) {
                return image.pixels[std::size_t(image.channels * (y * image.width + i))];
            };
            largest = std::max(largest, std::abs(at(x) - 0.5f * (at(x - 1) + at(x + 1))));
        }
    }
    return largest;
}

/// Ridges from the left to the right, on a plate whose triangles have an edge across the picture.
TEST_F(TextureTest, RidgesAcrossTheEdgesOfTriangles_HaveNoSpecks) {
    Scene ridges = plate();
    ridges.lights = {sun({0.0, 0.8, -0.6})};
    ridges.objects[0].material.model = block("models", "seen-ridges");
    ridges.objects[0].material.model.parameters["ridge.width"] = 0.04;
    View view = viewOf(ridges, 128);
    view.camera.distance = 2.0;
    view.samples = 4;
    const auto image = renderer->capture(ridges, view, meshSource(), false);
    ASSERT_TRUE(image) << image.error().text();
    EXPECT_LT(largestSpeck(*image), 0.01f);
}

} // namespace
} // namespace patina::texture_test
