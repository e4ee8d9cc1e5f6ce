// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of more triangles than pixels are drawn finer and averaged.
#include <algorithm>

#include "gpu_fixture.h"

namespace patina::dense_target_test {
namespace {

constexpr int size = 16; // far fewer pixels than the sphere has triangles

class DenseTarget : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    Image drawn(int pixels, int samples) {
        const Scene scene = simpleScene("phong");
        View view = viewOf(scene, pixels);
        view.samples = samples;
        auto image = renderer->capture(scene, view, meshSource(), false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }
};

TEST_F(DenseTarget, Pixel_IsTheMeanOfFourOfAPictureTwiceAsFine) {
    ASSERT_GT(mesh(object("phong")).indices.size() / 3, std::size_t(2 * size) * (2 * size));
    const Image image = drawn(size, 4);
    const Image fine = drawn(2 * size, 1);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::vec3 mean =
                0.25f * (pixel(fine, 2 * x, 2 * y) + pixel(fine, 2 * x + 1, 2 * y) +
                         pixel(fine, 2 * x, 2 * y + 1) + pixel(fine, 2 * x + 1, 2 * y + 1));
            // Half floats keep 11 bits; the mean is rounded once more.
            EXPECT_NEAR(pixel(image, x, y).g, mean.g, 2e-3f * std::max(1.0f, mean.g))
                << x << ", " << y;
        }
    }
}

TEST_F(DenseTarget, OneSample_IsDrawnAsItIs) {
    const Image image = drawn(size, 1);
    EXPECT_EQ(image.width, size);
    EXPECT_EQ(image.pixels, drawn(size, 1).pixels);
}

TEST_F(DenseTarget, ComesAndGoesWithTheTriangles) {
    Scene scene = simpleScene("phong");
    const Image dense = capture(scene, false, size);
    scene.objects[0].mesh = "builtin:cube";
    capture(scene, false, size);
    scene.objects[0].mesh = "builtin:sphere";
    EXPECT_EQ(capture(scene, false, size).pixels, dense.pixels);
}

} // namespace
} // namespace patina::dense_target_test
