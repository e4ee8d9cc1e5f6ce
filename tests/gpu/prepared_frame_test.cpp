// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame lacks before it is drawn, made one thing at a step.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "bound_programs.h"
#include "environment_fixture.h"
#include "frame_target.h"

namespace patina::prepared_frame_test {
namespace {

constexpr std::chrono::milliseconds noPatience{0};
constexpr int pixels = 520; // more than 2^18 of them
constexpr std::int64_t fewTexels = std::int64_t(1) << 18;

/// What takes long, as the driver is asked for it.
struct Pieces {
    int programs = 0;
    int targets = 0; ///< that a frame is drawn into
    int layers = 0;  ///< images of what is transparent
    int means = 0;   ///< of an environment's frames
    int tables = 0;  ///< of an environment, read back
    int rooms = 0;   ///< for the picture of an environment
    int parts = 0;   ///< of such a picture

    int all() const { return programs + targets + layers + means + tables + rooms + parts; }

    Pieces& operator+=(const Pieces& other) {
        programs += other.programs;
        targets += other.targets;
        layers += other.layers;
        means += other.means;
        tables += other.tables;
        rooms += other.rooms;
        parts += other.parts;
        return *this;
    }
};

/// Hears of what is made while it lives; there is one at a time.
class PiecesHeard {
  public:
    PiecesHeard() { heard_ = {}; }

    /// Those since the last call.
    static Pieces taken() { return std::exchange(heard_, {}); }

  private:
    static bool isLarge(GLsizei width, GLsizei height) {
        return std::int64_t(width) * height >= fewTexels;
    }
    static void noteLinked(GLuint) { ++heard_.programs; }
    static void noteLoaded(GLuint, GLenum, const void*, GLsizei) { ++heard_.programs; }
    static void noteBuffer(GLenum, GLsizei, GLenum format, GLsizei width, GLsizei height) {
        const bool isDepth = format == GL_DEPTH_COMPONENT32F; // each target has one
        heard_.targets += isDepth && isLarge(width, height) ? 1 : 0;
    }
    static void noteSamples(GLenum, GLsizei, GLenum, GLsizei width, GLsizei height, GLboolean) {
        heard_.layers += isLarge(width, height) ? 1 : 0;
    }
    static void noteImage(GLenum, GLint, GLint internalFormat, GLsizei width, GLsizei height, GLint,
                          GLenum, GLenum type, const void*) {
        if (isLarge(width, height)) {
            heard_.means += internalFormat == GL_RGBA32F ? 1 : 0;
            heard_.rooms += type == GL_HALF_FLOAT && width > pixels ? 1 : 0;
        }
    }
    static void notePart(GLenum, GLint, GLint, GLint, GLsizei width, GLsizei height, GLenum,
                         GLenum type, const void*) {
        heard_.parts += type == GL_HALF_FLOAT && isLarge(width, height) ? 1 : 0;
    }
    static void noteRead(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum type, void*) {
        heard_.tables += type == GL_FLOAT ? 1 : 0;
    }

    inline static Pieces heard_;

    Overheard<&epoxy_glLinkProgram, noteLinked> link_;
    Overheard<&epoxy_glProgramBinary, noteLoaded> load_;
    Overheard<&epoxy_glRenderbufferStorageMultisample, noteBuffer> buffer_;
    Overheard<&epoxy_glTexImage2DMultisample, noteSamples> samples_;
    Overheard<&epoxy_glTexImage2D, noteImage> image_;
    Overheard<&epoxy_glTexSubImage2D, notePart> part_;
    Overheard<&epoxy_glReadPixels, noteRead> read_;
};

class PreparedFrame : public EnvironmentTest {
  protected:
    void SetUp() override {
        EnvironmentTest::SetUp();
        size_ = pixels;
        target_.emplace(size_);
    }

    void TearDown() override {
        target_.reset();
        EnvironmentTest::TearDown();
    }

    bool begin(const Scene& scene) {
        return drawInWindow(scene, viewWith(scene, 4), squares(), target_->name());
    }

    /// What each step of a frame has made.
    std::vector<Pieces> drawInSteps(const Scene& scene) {
        PiecesHeard heard;
        std::vector<Pieces> steps;
        bool isDone = begin(scene);
        steps.push_back(PiecesHeard::taken());
        while (!isDone) {
            isDone = proceed(noPatience);
            steps.push_back(PiecesHeard::taken());
        }
        renderer->job().show(target_->name());
        return steps;
    }

    unsigned target() const { return target_->name(); }

    std::vector<std::uint8_t> drawnAtOnce(const Scene& scene) {
        renderer->draw(scene, viewWith(scene, 4), squares(), target_->name());
        return picture();
    }

    std::vector<std::uint8_t> picture() const { return target_->picture(); }

    Scene layered(const std::string& transparency) const {
        Scene scene = simpleScene("phong");
        scene.objects[0].mesh = "square";
        scene.objects[0].material.opacity = 0.5;
        scene.setPart(kinds::transparency, block("transparency", transparency));
        return scene;
    }

    static Pieces sum(const std::vector<Pieces>& steps) {
        Pieces all;
        for (const Pieces& step : steps) {
            all += step;
        }
        return all;
    }

    static int maxInAStep(const std::vector<Pieces>& steps) {
        int largest = 0;
        for (const Pieces& step : steps) {
            largest = std::max(largest, step.all());
        }
        return largest;
    }

  private:
    std::optional<FrameTarget> target_;
};

TEST_F(PreparedFrame, TheFirstOne_MakesOneThingAtAStep) {
    const auto steps = drawInSteps(square("phong"));
    EXPECT_EQ(maxInAStep(steps), 1);
    EXPECT_EQ(sum(steps).targets, 1);
    EXPECT_EQ(sum(steps).programs, 2); // the surface's and the screen's
}

TEST_F(PreparedFrame, WithPeeledLayers_MakesOneThingAtAStep) {
    drawInSteps(square("phong"));
    const auto steps = drawInSteps(layered("peeled"));
    EXPECT_EQ(maxInAStep(steps), 1);
    EXPECT_EQ(sum(steps).layers, 3); // colours, and two of depths
    EXPECT_EQ(sum(steps).targets, 0);
}

TEST_F(PreparedFrame, WithMixedLayers_MakesOneThingAtAStep) {
    drawInSteps(square("phong"));
    const auto steps = drawInSteps(layered("weighted"));
    EXPECT_EQ(maxInAStep(steps), 1);
    EXPECT_EQ(sum(steps).layers, 2);
}

TEST_F(PreparedFrame, InTheStudio_MakesOneThingAtAStep) {
    drawInSteps(square("phong"));
    const auto steps = drawInSteps(inTheStudio("phong"));
    EXPECT_EQ(sum(steps).means, 1);
    EXPECT_EQ(sum(steps).tables, 1);
    EXPECT_EQ(maxInAStep(steps), 1);
}

TEST_F(PreparedFrame, WithAnotherPanorama_TakesItInPartByPart) {
    drawInSteps(surrounded("phong", plain(0.5f)));
    const auto steps = drawInSteps(surrounded("phong", plain(1.0f, {2048, 1024})));
    EXPECT_EQ(maxInAStep(steps), 1);
    EXPECT_EQ(sum(steps).rooms, 1);
    EXPECT_EQ(sum(steps).parts, 2); // of 8 MiB
    EXPECT_EQ(sum(steps).tables, 1);
}

TEST_F(PreparedFrame, ASecondTime_LacksNothing) {
    for (const Scene& scene : {layered("peeled"), inTheStudio("phong")}) {
        drawInSteps(scene);
        EXPECT_EQ(sum(drawInSteps(scene)).all(), 0);
    }
}

TEST_F(PreparedFrame, InSteps_IsThePictureDrawnAtOnce) {
    Scene scene = layered("peeled");
    scene.setPart(kinds::environment, block("environment", "studio"));
    drawInSteps(scene);
    const auto stepped = picture();
    makeRenderer();
    EXPECT_EQ(stepped, drawnAtOnce(scene));
}

TEST_F(PreparedFrame, GivenUpAtAnyStep_SpoilsNoLaterOne) {
    Scene scene = layered("weighted");
    scene.setPart(kinds::environment, block("environment", "studio"));
    const Scene other = square("lambert");
    const auto expected = drawnAtOnce(scene);
    const auto expectedOther = drawnAtOnce(other);
    for (int given = 0; given < 12; ++given) {
        makeRenderer();
        ASSERT_FALSE(begin(scene));
        for (int step = 0; step < given; ++step) {
            proceed(noPatience);
        }
        ASSERT_EQ(drawnAtOnce(other), expectedOther) << given;
        ASSERT_EQ(drawnAtOnce(scene), expected) << given;
    }
}

TEST_F(PreparedFrame, ThatCannotBeMade_IsDoneAndLeavesTheFramebufferAsItWas) {
    const auto before = drawnAtOnce(square("phong"));
    makeRenderer();
    View view = viewWith(square("phong"), 4);
    view.size = glm::ivec2(1 << 24);
    bool isDone = drawInWindow(square("phong"), view, squares(), target());
    EXPECT_FALSE(isDone); // programs came first
    while (!isDone) {
        isDone = proceed(noPatience);
    }
    renderer->job().show(target());
    EXPECT_EQ(renderer->report().messages.size(), 1u);
    EXPECT_EQ(picture(), before);
}

} // namespace
} // namespace patina::prepared_frame_test
