// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps its size on the screen does so on a screen of another pixel density.
#include <cmath>

#include "gpu_fixture.h"

namespace patina::pixel_ratio_test {
namespace {

constexpr int usualSize = 64;

class PixelRatio : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// A ball drawn in black on white.
    Scene drawn(const std::string& model) const {
        Scene scene = simpleScene(model);
        scene.lights = {sun({-0.6, -0.4, -1.0})};
        scene.camera.distance = 3.6;
        Values& values = scene.objects[0].material.model.parameters;
        values["diffuse.color"] = glm::dvec3(1.0);
        values["ink.color"] = glm::dvec3(0.0);
        return scene;
    }

    Image picture(const Scene& scene, double ratio, int size) {
        View view = viewOf(scene, size);
        view.pixelRatio = ratio;
        const auto image = renderer->capture(scene, view, meshSource(), false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    /// The mean difference between a picture and one of twice its size.
    static double apart(const Image& small, const Image& large) {
        double sum = 0.0;
        for (int y = 0; y < small.height; ++y) {
            for (int x = 0; x < small.width; ++x) {
                float mean = 0.0f;
                for (int i = 0; i < 4; ++i) {
                    mean += 0.25f * pixel(large, 2 * x + i % 2, 2 * y + i / 2).g;
                }
                sum += std::abs(double(mean) - double(pixel(small, x, y).g));
            }
        }
        return sum / (small.width * small.height);
    }

    /// Expects a picture of twice the size and ratio to show the same marks, and one of twice the
    /// size alone to show others.
    void expectToHoldItsSize(const Scene& scene) {
        const Image usual = picture(scene, 1.0, usualSize);
        const double same = apart(usual, picture(scene, 2.0, 2 * usualSize));
        EXPECT_LT(same, 0.03);
        EXPECT_GT(apart(usual, picture(scene, 1.0, 2 * usualSize)), 3.0 * same);
    }
};

TEST_F(PixelRatio, ScreenOfTwiceTheDensity_ShowsTheSameDotsOnThePicture) {
    expectToHoldItsSize(drawn("halftone"));
}

TEST_F(PixelRatio, ScreenOfTwiceTheDensity_ShowsTheSameLinesOnTheSurface) {
    expectToHoldItsSize(drawn("engraving"));
}

TEST_F(PixelRatio, ScreenOfTwiceTheDensity_ShowsOutlinesOfTheSameWidth) {
    Scene scene = simpleScene();
    BlockValues lines = block("outline", "ink-line");
    lines.parameters["width"] = 6.0;
    scene.objects[0].material.parts["outline"] = lines;
    scene.camera.distance = 4.0;
    expectToHoldItsSize(scene);
}

/// Lines of 10.3 pixels, 20.6 apart: a row of 320 pixels crosses 32 edges, each in two pixels at
/// most.
TEST_F(PixelRatio, EdgesOfMarks_StayAPixelWide) {
    Scene scene = plate();
    scene.objects[0].material.model = block("models", "halftone");
    Values& values = scene.objects[0].material.model.parameters;
    values["pattern"] = std::string("lines");
    values["diffuse.color"] = glm::dvec3(1.0);
    values["ink.color"] = glm::dvec3(0.0);
    values["angle"] = 90.0;
    values["cell"] = 10.3;
    values["tone.light"] = 1.0;
    values["tone.dark"] = 0.5;
    scene.lights = {sun({std::sqrt(1.0 - 0.75 * 0.75), 0.0, -0.75})};
    scene.camera.distance = 0.5;
    constexpr int wide = 320;
    const Image image = picture(scene, 2.0, wide);
    int edges = 0;
    for (int x = 0; x < wide; ++x) {
        const float shown = pixel(image, x, wide / 2).g;
        edges += shown > 0.01f && shown < 0.99f ? 1 : 0;
    }
    EXPECT_LE(edges, 2 * 32);
    EXPECT_GE(edges, 16);
}

} // namespace
} // namespace patina::pixel_ratio_test
