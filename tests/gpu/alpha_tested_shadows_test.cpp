// SPDX-License-Identifier: GPL-3.0-or-later
// Shadows of surfaces that an image cuts holes into: a square over a floor, seen from above beside
// the square, where its shadow falls.
#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "assets/texture_maker.h"
#include "gpu_fixture.h"
#include "render/lights/ground_place.h"

namespace patina::alpha_tested_shadows_test {
namespace {

constexpr int fieldPixels = 128;
constexpr double fieldAngle = 12.0; // degrees
constexpr double height = 2.0;      // of the square, as far as its shadow lies beside it
constexpr double doubt = 0.03;      // metres: some texels of the map

class AlphaTestedShadowsTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        renderer->setTextures([this](const TextureUse&, TextureDecoding) {
            return TextureLookup{isThere ? picture : nullptr, false};
        });
        meshes["level"] = groundMesh();
        Object square = object("lambert", "plane");
        square.translation.y = height;
        Object floor = object("lambert", "level");
        floor.scale = glm::dvec3(50.0, 1.0, 50.0);
        floor.castsShadow = false;
        scene.objects = {square, floor};
        scene.lights = {sun({1.0, -1.0, 0.0})};
        scene.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
        scene.camera.pivot = {height, 0.0, 0.0};
        scene.camera.yaw = 0.0;
        scene.camera.pitch = 90.0;
        scene.camera.distance = 8.0;
        scene.camera.fieldOfView = fieldAngle;
    }

    /// Two fields beside each other with these opacities.
    TextureUse& useMask(float left, float right) {
        picture = std::make_shared<const TexturePicture>(
            madeTexture({{2, 1, 1, {left, right}}, 0}, TextureDecoding::Linear));
        TextureUse& use = scene.objects[0].material.textures["opacity"];
        use.file = "mask";
        use.channel = TextureChannel::Red;
        return use;
    }

    /// Whether the middle of the square's left field, u < 1/2, is at negative x.
    bool isLeftAtNegativeX() {
        const Mesh plane = *primitive("plane");
        const auto found = std::ranges::max_element(
            plane.vertices, {}, [](const Vertex& vertex) { return vertex.position.x; });
        return found->uv.x > 0.5f;
    }

    /// The shares of pixels that are dark, of the shadow of the left field and of the right one.
    glm::dvec2 darkShares() {
        const Image image = capture(scene, false, fieldPixels);
        const double step =
            2.0 * scene.camera.distance * std::tan(glm::radians(0.5 * fieldAngle)) / fieldPixels;
        glm::dvec2 dark(0.0);
        glm::dvec2 all(0.0);
        for (int i = 0; i < fieldPixels * fieldPixels; ++i) {
            const double x = (i % fieldPixels + 0.5 - 0.5 * fieldPixels) * step;
            if (std::abs(x) < doubt) {
                continue;
            }
            const int side = (x < 0.0) == isLeftAtNegativeX() ? 0 : 1;
            dark[side] += pixel(image, i % fieldPixels, i / fieldPixels).r < 0.01f;
            all[side] += 1.0;
        }
        return dark / all;
    }

    Scene scene;
    bool isThere = true;
    std::shared_ptr<const TexturePicture> picture;
};

TEST_F(AlphaTestedShadowsTest, WithoutAnImage_IsDarkAllOver) {
    EXPECT_EQ(darkShares(), glm::dvec2(1.0));
}

TEST_F(AlphaTestedShadowsTest, CutOut_LetsLightThroughItsHoles) {
    useMask(1.0f, 0.0f).cutOut = true;
    EXPECT_EQ(darkShares(), glm::dvec2(1.0, 0.0));
    useMask(0.0f, 1.0f);
    EXPECT_EQ(darkShares(), glm::dvec2(0.0, 1.0));
}

TEST_F(AlphaTestedShadowsTest, CutOut_GoesByItsThreshold) {
    TextureUse& use = useMask(0.75f, 0.25f);
    use.cutOut = true;
    use.threshold = 0.5;
    EXPECT_EQ(darkShares(), glm::dvec2(1.0, 0.0));
    use.threshold = 0.1;
    EXPECT_EQ(darkShares(), glm::dvec2(1.0));
    EXPECT_GT(renderer->report().shadowMaps, 0);
    use.threshold = 0.9;
    EXPECT_EQ(darkShares(), glm::dvec2(0.0));
}

TEST_F(AlphaTestedShadowsTest, ImageOfOpacities_CastsWhereAtLeastHalfIsThere) {
    useMask(0.3f, 0.7f);
    EXPECT_EQ(darkShares(), glm::dvec2(0.0, 1.0));
}

TEST_F(AlphaTestedShadowsTest, ImageThatComesLater_IsThenInTheShadow) {
    useMask(1.0f, 0.0f).cutOut = true;
    isThere = false;
    EXPECT_EQ(darkShares(), glm::dvec2(1.0));
    isThere = true;
    EXPECT_EQ(darkShares(), glm::dvec2(1.0, 0.0));
}

TEST_F(AlphaTestedShadowsTest, WhereNothingChanges_AreNotDrawnAgain) {
    useMask(1.0f, 0.0f).cutOut = true;
    darkShares();
    darkShares(); // the image is whole now
    darkShares();
    EXPECT_EQ(renderer->report().shadowMaps, 0);
    EXPECT_EQ(renderer->report().compiled, 0);
}

/// Two squares, of which the first and then the second has holes.
TEST_F(AlphaTestedShadowsTest, OfAnotherObject_AreDrawnAgain) {
    useMask(1.0f, 0.0f).cutOut = true;
    Object far = scene.objects[0];
    far.translation.z = 4.0;
    far.material.textures.clear();
    scene.objects.push_back(far);
    EXPECT_EQ(darkShares(), glm::dvec2(1.0, 0.0));
    std::swap(scene.objects[0].material, scene.objects[2].material);
    EXPECT_EQ(darkShares(), glm::dvec2(1.0));
}

} // namespace
} // namespace patina::alpha_tested_shadows_test
