// SPDX-License-Identifier: GPL-3.0-or-later
// Views whose shadows differ: each has maps of its own, within one budget of memory.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <epoxy/gl.h>

#include "gpu_fixture.h"
#include "render/pass/render_resources.h"

namespace patina::tests::shadow_map_pool_test {
namespace {

constexpr int size = 32;
constexpr int texels = 256;
constexpr std::int64_t mapBytes = std::int64_t(4) * texels * texels;

/// Counts the triangles that are drawn while it lives.
class TriangleCount {
  public:
    TriangleCount() {
        glGenQueries(1, &query_);
        glBeginQuery(GL_PRIMITIVES_GENERATED, query_);
    }
    TriangleCount(const TriangleCount&) = delete;
    TriangleCount& operator=(const TriangleCount&) = delete;
    ~TriangleCount() { glDeleteQueries(1, &query_); }

    std::int64_t end() const {
        GLuint count = 0;
        glEndQuery(GL_PRIMITIVES_GENERATED);
        glGetQueryObjectuiv(query_, GL_QUERY_RESULT, &count);
        return count;
    }

  private:
    GLuint query_ = 0;
};

class ShadowMapsOfViews : public GpuTest {
  protected:
    static constexpr int most = 1000; ///< is more steps than any frame here takes

    void SetUp() override {
        GpuTest::SetUp();
        use(16);
    }

    void TearDown() override {
        jobs_.clear();
        shared.reset();
        GpuTest::TearDown();
    }

    /// Begins anew with memory for so many maps.
    void use(int maps) {
        jobs_.clear();
        shared = std::make_shared<RenderResources>("");
        shared->setCatalog(catalog);
        shared->shadows.setLimits({texels, maps * mapBytes});
    }

    FrameJob& view() {
        jobs_.push_back(std::make_unique<FrameJob>(shared));
        return *jobs_.back();
    }

    /// A ball in the shadow of a cube `x` metres beside the middle.
    Scene shadowed(double x) {
        Scene scene = simpleScene("lambert");
        scene.objects.push_back(object("lambert", "cube"));
        scene.objects[1].translation = {x, 1.5, 1.5};
        scene.lights = {sun({0.0, -1.0, -1.0})};
        scene.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
        return scene;
    }

    /// So many triangles that a frame takes several steps, in the light of two suns; those behind
    /// the camera only cast shadows.
    Scene large(double x) {
        Scene scene = shadowed(x);
        scene.lights.push_back(scene.lights[0]);
        scene.lights[1].block.parameters["direction"] = glm::dvec3(1.0, -1.0, 0.0);
        for (int i = 0; i < 6; ++i) {
            scene.objects.push_back(object("lambert", "torus"));
            scene.objects.back().translation = {0.3 * i - 1.0 + x, 6.0 + 0.2 * i, 6.0};
        }
        return scene;
    }

    void begin(FrameJob& job, const Scene& scene) {
        job.begin(scene, viewOf(scene, size), meshSource(), FramePurpose::Capture);
    }

    /// Draws about one slice of triangles; returns true when the frame is done.
    static bool step(FrameJob& job) {
        glFinish(); // else it might wait for the device
        return job.step(FrameJob::Clock::now()) == FrameJob::Progress::Done;
    }

    /// Returns how many shadow maps were drawn.
    int draw(FrameJob& job, const Scene& scene) {
        begin(job, scene);
        job.step(FrameJob::never);
        EXPECT_FALSE(job.failure());
        return job.report().shadowMaps;
    }

    /// The picture of a view that shares nothing.
    std::vector<float> alone(const Scene& scene) {
        auto made = Renderer::create({.programCache = {}, .shadowTexels = texels});
        EXPECT_TRUE(made);
        (*made)->setCatalog(catalog);
        const auto image = (*made)->capture(scene, viewOf(scene, size), meshSource(), false);
        EXPECT_TRUE(image);
        return image ? image->pixels : std::vector<float>();
    }

    /// Goes on with both until they are done. Returns the most triangles that a step has drawn.
    std::int64_t finishInTurns(FrameJob& first, FrameJob& second) {
        std::int64_t triangles = 0;
        for (int steps = 0; steps < most; ++steps) {
            bool isDone = true;
            for (FrameJob* job : {&first, &second}) {
                const TriangleCount count;
                isDone &= step(*job);
                triangles = std::max(triangles, count.end());
                EXPECT_LE(shared->shadows.bytes(), shared->shadows.limits().bytes);
            }
            if (isDone) {
                return triangles;
            }
        }
        ADD_FAILURE() << "they keep each other from being done";
        return triangles;
    }

    std::shared_ptr<RenderResources> shared;

  private:
    std::vector<std::unique_ptr<FrameJob>> jobs_;
};

TEST_F(ShadowMapsOfViews, OfOtherCasters_AreDrawnOncePerView) {
    FrameJob& first = view();
    FrameJob& second = view();
    EXPECT_EQ(draw(first, shadowed(0.0)), 1);
    EXPECT_EQ(draw(second, shadowed(0.5)), 1);
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(draw(first, shadowed(0.0)), 0);
        EXPECT_EQ(draw(second, shadowed(0.5)), 0);
    }
    EXPECT_EQ(shared->shadows.bytes(), 2 * mapBytes);
}

TEST_F(ShadowMapsOfViews, OfOneSceneWhileACasterIsDragged_AreDrawnOncePerFrameInLittleMemory) {
    FrameJob& first = view();
    FrameJob& second = view();
    for (int frame = 0; frame < 5; ++frame) {
        const Scene scene = shadowed(0.1 * frame);
        EXPECT_EQ(draw(first, scene), 1);
        EXPECT_EQ(draw(second, scene), 0);
    }
    EXPECT_LE(shared->shadows.bytes(), 2 * mapBytes);
}

/// The other one has no shadows and is drawn again and again.
TEST_F(ShadowMapsOfViews, ThatNoFrameWantsForLong_AreFreed) {
    FrameJob& first = view();
    Scene dark = shadowed(0.0);
    draw(first, dark);
    dark.lights[0].setPart(kinds::shadows, std::nullopt);
    FrameJob& second = view();
    draw(second, dark);
    EXPECT_EQ(shared->shadows.bytes(), mapBytes);
    for (std::uint64_t frame = 0; frame < ShadowMapPool::framesKept; ++frame) {
        shared->shadows.beginFrame();
    }
    EXPECT_EQ(shared->shadows.bytes(), 0);
    EXPECT_EQ(draw(first, shadowed(0.0)), 1);
}

TEST_F(ShadowMapsOfViews, LargeInTurns_AreDrawnInStepsForThePicturesOfEachAlone) {
    const Scene one = large(0.0);
    const Scene other = large(0.4);
    FrameJob& first = view();
    FrameJob& second = view();
    begin(first, one);
    begin(second, other);
    const std::int64_t slice = 16384;
    EXPECT_LE(finishInTurns(first, second), 2 * slice);
    EXPECT_EQ(first.read(false)->pixels, alone(one));
    EXPECT_EQ(second.read(false)->pixels, alone(other));
}

/// There is memory for the maps of one: the other one waits.
TEST_F(ShadowMapsOfViews, BeyondTheMemory_AreDrawnOneAfterTheOther) {
    use(3);
    const Scene one = large(0.0);
    const Scene other = large(0.4);
    FrameJob& first = view();
    FrameJob& second = view();
    begin(first, one);
    begin(second, other);
    for (bool isDone = false; !isDone;) {
        isDone = step(first);
        EXPECT_FALSE(step(second));
    }
    EXPECT_EQ(first.read(false)->pixels, alone(one));
    finishInTurns(first, second);
    EXPECT_EQ(second.read(false)->pixels, alone(other));
}

TEST_F(ShadowMapsOfViews, OfAFrameThatNobodyGoesOnWith_MakeRoom) {
    use(3);
    const Scene one = large(0.0);
    const Scene other = large(0.4);
    FrameJob& first = view();
    begin(first, one);
    for (int steps = 0; steps < 3; ++steps) {
        ASSERT_FALSE(step(first));
    }
    FrameJob& second = view();
    begin(second, other);
    int steps = 0;
    while (!step(second) && steps < most) {
        ++steps;
    }
    ASSERT_LT(steps, most);
    EXPECT_EQ(second.read(false)->pixels, alone(other));
    finishInTurns(first, second);
    EXPECT_EQ(first.read(false)->pixels, alone(one)) << "its maps come back";
}

/// A picture that is wanted at once does not wait.
TEST_F(ShadowMapsOfViews, WantedAtOnce_TakeThoseOfAFrameOnItsWay) {
    use(3);
    const Scene one = large(0.0);
    FrameJob& first = view();
    begin(first, one);
    for (int steps = 0; steps < 3; ++steps) {
        ASSERT_FALSE(step(first));
    }
    EXPECT_EQ(draw(view(), large(0.4)), 2);
    while (!step(first)) {
    }
    EXPECT_EQ(first.read(false)->pixels, alone(one));
}

} // namespace
} // namespace patina::tests::shadow_map_pool_test
