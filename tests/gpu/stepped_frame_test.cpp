// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of many triangles, drawn bit by bit.
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include <epoxy/gl.h>

#include "frame_target.h"
#include "gpu_fixture.h"
#include "render/gpu/row_tiles.h"

namespace patina::stepped_frame_test {
namespace {

using std::chrono::milliseconds;

constexpr int pixels = 64;
constexpr int gridSide = 330; // 2 * 329^2 triangles: 216 000
constexpr milliseconds noPatience{0};

/// A square across the line of sight with waves in it, in triangles smaller than pixels.
Mesh wavyGrid() {
    Mesh mesh;
    for (int row = 0; row < gridSide; ++row) {
        for (int column = 0; column < gridSide; ++column) {
            const float x = 2.0f * float(column) / (gridSide - 1) - 1.0f;
            const float y = 2.0f * float(row) / (gridSide - 1) - 1.0f;
            Vertex vertex;
            vertex.position = {x, y, 0.2f * float((row / 16 + column / 16) % 2)};
            mesh.vertices.push_back(vertex);
        }
    }
    for (std::uint32_t row = 0; row + 1 < gridSide; ++row) {
        for (std::uint32_t column = 0; column + 1 < gridSide; ++column) {
            const std::uint32_t a = row * gridSide + column;
            const std::uint32_t b = a + gridSide;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b, a + 1, b + 1, b});
        }
    }
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

class SteppedFrame : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        meshes["grid"] = wavyGrid();
        target_.emplace(pixels);
    }

    void TearDown() override {
        target_.reset();
        GpuTest::TearDown();
    }

    Scene gridScene(double opacity = 1.0) {
        Scene scene = simpleScene("phong");
        scene.objects[0].mesh = "grid";
        scene.objects[0].material.opacity = opacity;
        scene.objects[0].rotation = {20.0, 30.0, 0.0};
        return scene;
    }

    bool beginFrame(const Scene& scene) {
        return drawInWindow(scene, viewOf(scene, pixels), meshSource(), target_->name());
    }

    /// A frame that takes as long as it likes, and what it is then said to have taken.
    void drawFrame(const Scene& scene, double taken) {
        if (!beginFrame(scene)) {
            finishFrame();
        }
        renderer->job().noteTime(taken);
    }

    /// The number of further steps.
    int finishFrame() {
        int steps = 1;
        while (!proceed(noPatience)) {
            ++steps;
        }
        renderer->job().show(target_->name());
        return steps;
    }

    std::vector<std::uint8_t> drawnAtOnce(const Scene& scene) {
        renderer->draw(scene, viewOf(scene, pixels), meshSource(), target_->name());
        return picture();
    }

    std::vector<std::uint8_t> picture() const { return target_->picture(); }

  private:
    std::optional<FrameTarget> target_;
};

TEST_F(SteppedFrame, OfManyTriangles_TakesMoreThanOneStepForEachMegabyte) {
    const Scene scene = gridScene();
    ASSERT_FALSE(beginFrame(scene));
    // 108 900 vertices of 48 bytes and 216 000 triangles: 7.5 MiB to upload, then the drawing.
    EXPECT_GT(finishFrame(), 8);
}

TEST_F(SteppedFrame, NotDone_LeavesTheFramebufferAsItWas) {
    const auto before = drawnAtOnce(simpleScene());
    ASSERT_FALSE(beginFrame(gridScene()));
    proceed(noPatience);
    EXPECT_EQ(picture(), before);
}

TEST_F(SteppedFrame, Done_IsThePictureDrawnAtOnce) {
    const Scene scene = gridScene();
    ASSERT_FALSE(beginFrame(scene));
    finishFrame();
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

TEST_F(SteppedFrame, OfTransparentObjects_IsThePictureDrawnAtOnce) {
    Scene scene = gridScene(0.5);
    scene.objects.push_back(object("lambert"));
    ASSERT_FALSE(beginFrame(scene));
    finishFrame();
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

TEST_F(SteppedFrame, OfWhatBendsLight_IsThePictureDrawnAtOnce) {
    Scene scene = gridScene(0.2);
    scene.objects[0].material.parts["refraction"] = block("refraction", "solid-body");
    scene.objects.push_back(object("lambert"));
    scene.objects[1].translation.z = -1.0;
    ASSERT_FALSE(beginFrame(scene));
    EXPECT_GT(finishFrame(), 2 * 13); // its back, then itself
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

TEST_F(SteppedFrame, WithShadowsAndAGround_IsThePictureDrawnAtOnce) {
    Scene scene = gridScene();
    scene.lights = {sun({0.5, -1.0, -1.0}), light("point")};
    scene.lights[0].setPart(kinds::shadows, block("shadows", "filtered"));
    scene.lights[1].setPart(kinds::shadows, block("shadows", "hard"));
    scene.ground.mode = GroundMode::Plane;
    ASSERT_FALSE(beginFrame(scene));
    EXPECT_EQ(renderer->report().shadowMaps, 7);
    EXPECT_GT(finishFrame(), 7 * 13); // each map takes thirteen slices or so
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

TEST_F(SteppedFrame, GivenUpInMidShadows_DrawsThemTheNextTime) {
    Scene scene = gridScene();
    scene.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
    ASSERT_FALSE(beginFrame(scene));
    for (int i = 0; i < 12; ++i) {
        proceed(noPatience);
    }
    const auto resumed = drawnAtOnce(scene);
    scene.objects[0].translation.x = 1.0;
    drawnAtOnce(scene);
    scene.objects[0].translation.x = 0.0;
    EXPECT_EQ(resumed, drawnAtOnce(scene));
}

TEST_F(SteppedFrame, NotDone_GivesWayToAnother) {
    const Scene other = simpleScene();
    const auto expected = drawnAtOnce(other);
    ASSERT_FALSE(beginFrame(gridScene(0.5)));
    proceed(noPatience);
    EXPECT_EQ(drawnAtOnce(other), expected);
}

TEST_F(SteppedFrame, GivenUpInMidUpload_IsCompleteTheNextTime) {
    const Scene scene = gridScene();
    ASSERT_FALSE(beginFrame(scene));
    drawnAtOnce(simpleScene());
    const auto later = drawnAtOnce(scene);
    makeRenderer();
    EXPECT_EQ(drawnAtOnce(scene), later);
}

TEST_F(SteppedFrame, Reported_CountsEachObjectOnce) {
    ASSERT_FALSE(beginFrame(gridScene()));
    finishFrame();
    EXPECT_EQ(renderer->report().drawnObjects, 1);
}

/// A scene of few triangles of which some cover others.
Scene costlyScene(Scene scene, const Object& behind) {
    scene.objects.push_back(behind);
    scene.objects.back().translation.z = -0.5;
    return scene;
}

TEST_F(SteppedFrame, ThatTookLongTheLastTime_TakesManySteps) {
    const Scene scene = simpleScene("phong");
    drawFrame(scene, 5000.0);
    ASSERT_FALSE(beginFrame(scene));
    EXPECT_GT(finishFrame(), 2);
}

TEST_F(SteppedFrame, ThatTookLongTheLastTime_IsThePictureDrawnAtOnce) {
    const Scene scene = costlyScene(simpleScene("phong"), object("lambert"));
    drawFrame(scene, 5000.0);
    ASSERT_FALSE(beginFrame(scene));
    finishFrame();
    EXPECT_EQ(renderer->report().drawnObjects, 2);
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

/// With a ground too: no row may blend twice.
TEST_F(SteppedFrame, ThatTookLongAndBlends_IsThePictureDrawnAtOnce) {
    Scene scene = costlyScene(simpleScene("phong"), object("lambert"));
    scene.objects[0].material.opacity = 0.5;
    scene.ground.mode = GroundMode::Plane;
    drawFrame(scene, 5000.0);
    ASSERT_FALSE(beginFrame(scene));
    EXPECT_GT(finishFrame(), 2);
    EXPECT_EQ(renderer->report().drawnObjects, 2);
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

/// Each layer takes slices of its own.
TEST_F(SteppedFrame, ThatTookLongAndIsPeeled_IsThePictureDrawnAtOnce) {
    Scene scene = costlyScene(simpleScene("phong"), object("lambert"));
    scene.objects[0].material.opacity = 0.5;
    scene.objects[1].material.opacity = 0.7;
    scene.setPart(kinds::transparency, block("transparency", "peeled"));
    drawFrame(scene, 5000.0);
    ASSERT_FALSE(beginFrame(scene));
    EXPECT_GT(finishFrame(), 12);
    EXPECT_EQ(renderer->report().drawnObjects, 2);
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

TEST_F(SteppedFrame, ThatTookLongAndIsMixed_IsThePictureDrawnAtOnce) {
    Scene scene = costlyScene(simpleScene("phong"), object("lambert"));
    scene.objects[0].material.opacity = 0.5;
    scene.setPart(kinds::transparency, block("transparency", "weighted"));
    drawFrame(scene, 5000.0);
    ASSERT_FALSE(beginFrame(scene));
    EXPECT_GT(finishFrame(), 4);
    const auto stepped = picture();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

TEST_F(SteppedFrame, GivenUpInMidLayer_IsCompleteTheNextTime) {
    Scene scene = costlyScene(simpleScene("phong"), object("lambert"));
    scene.objects[0].material.opacity = 0.5;
    scene.setPart(kinds::transparency, block("transparency", "peeled"));
    const auto expected = drawnAtOnce(scene);
    for (int given = 1; given < 12; ++given) {
        drawFrame(scene, 5000.0);
        ASSERT_FALSE(beginFrame(scene));
        for (int step = 0; step < given; ++step) {
            proceed(noPatience);
        }
        ASSERT_EQ(drawnAtOnce(scene), expected) << given;
    }
}

TEST_F(SteppedFrame, ThatTookLittleTheLastTime_IsDrawnAtOnce) {
    const Scene scene = simpleScene("phong");
    drawFrame(scene, 5000.0);
    drawFrame(scene, 20.0);
    EXPECT_TRUE(beginFrame(scene));
}

TEST(RowTiles, PaceOfAFrameOfOtherPrograms_IsUnknown) {
    const int program = 0;
    const int other = 1;
    RowTiles tiles;
    tiles.begin(std::array<const void*, 1>{&program}, {64, 64}, 100);
    EXPECT_EQ(tiles.pace(), RowTiles::Pace::Unknown);
    tiles.noteTime(20.0);
    EXPECT_EQ(tiles.pace(), RowTiles::Pace::Quick);
    tiles.begin(std::array<const void*, 1>{&other}, {64, 64}, 100);
    EXPECT_EQ(tiles.pace(), RowTiles::Pace::Unknown);
}

TEST(RowTiles, PaceOfAFrameThatTookLong_IsSlow) {
    RowTiles tiles;
    tiles.begin({}, {64, 64}, 100);
    tiles.noteTime(500.0);
    tiles.begin({}, {64, 64}, 100);
    EXPECT_EQ(tiles.pace(), RowTiles::Pace::Slow);
}

} // namespace
} // namespace patina::stepped_frame_test
