// SPDX-License-Identifier: GPL-3.0-or-later
// Frames of one sample per pixel, and what they hold.
#include <epoxy/gl.h>

#include "gpu_fixture.h"

namespace patina::one_sample_test {
namespace {

/// A half float keeps 11 bits.
constexpr float half = 1e-3f;

/// Counts the copies between framebuffers while it lives.
class BlitCounter {
  public:
    BlitCounter() : before_(glBlitFramebuffer) {
        count_ = 0;
        original_ = before_;
        glBlitFramebuffer = counted;
    }
    ~BlitCounter() { glBlitFramebuffer = before_; }
    BlitCounter(const BlitCounter&) = delete;
    BlitCounter& operator=(const BlitCounter&) = delete;

    int count() const { return count_; }

  private:
    static void EPOXY_CALLSPEC counted(GLint x0, GLint y0, GLint x1, GLint y1, GLint toX0,
                                       GLint toY0, GLint toX1, GLint toY1, GLbitfield mask,
                                       GLenum filter) {
        ++count_;
        original_(x0, y0, x1, y1, toX0, toY0, toX1, toY1, mask, filter);
    }

    PFNGLBLITFRAMEBUFFERPROC before_;
    static inline PFNGLBLITFRAMEBUFFERPROC original_ = nullptr;
    static inline int count_ = 0;
};

class OneSample : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }
};

TEST_F(OneSample, Glow_MayBeBrighterThanWhite) {
    Scene scene = plate();
    scene.lights.clear();
    scene.objects[0].material.model.parameters["emissive.color"] = glm::dvec3(0.0, 12.0, 0.0);
    EXPECT_NEAR(middle(capture(scene)).g, 12.0f, 0.02f);
}

/// With one sample per pixel the picture is drawn into what is shown.
TEST_F(OneSample, PerPixel_ResolvesNothing) {
    const Scene scene = plate();
    View view = viewOf(scene);
    view.samples = 4;
    ASSERT_TRUE(renderer->capture(scene, view, meshSource(), false));
    view.samples = 1;
    const BlitCounter counter; // epoxy has looked for the function by now
    const auto plain = renderer->capture(scene, view, meshSource(), false);
    ASSERT_TRUE(plain);
    EXPECT_EQ(counter.count(), 0);
    view.samples = 4;
    const auto averaged = renderer->capture(scene, view, meshSource(), false);
    ASSERT_TRUE(averaged);
    EXPECT_EQ(counter.count(), 1);
    EXPECT_NEAR(middle(*averaged).g, middle(*plain).g, half);
}

} // namespace
} // namespace patina::one_sample_test
