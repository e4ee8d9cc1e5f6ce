// SPDX-License-Identifier: GPL-3.0-or-later
// Frames and their errors, worked out in slices, are the same as those that are made at once.
#include "measure/error/incremental_capture.h"

#include <algorithm>
#include <ctime>

#include "gpu_fixture.h"
#include "measure/error/frame_error.h"
#include "measure/error/parallel.h"

namespace patina::incremental_capture_test {
namespace {

constexpr std::chrono::milliseconds noPatience{0};

/// How long a window may stand still, and how long a step is asked to work.
constexpr double longestMs = 100.0;
constexpr std::chrono::milliseconds patience{20};

/// What all cores have worked for this process, as if it had them to itself: other work on the
/// machine does not count.
double workedMs() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec)) / double(parallelParts());
}

/// The longest of the steps until one says that all is done.
template <class Step>
double longestOf(const Step& step) {
    double longest = 0.0;
    bool done = false;
    while (!done) {
        const double before = workedMs();
        done = step();
        longest = std::max(longest, workedMs() - before);
    }
    return longest;
}

class IncrementalCaptureTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        source_ = meshSource();
    }

    ChosenFrame frameOf(const Scene& scene, int edge) const {
        ChosenFrame frame{scene, viewOf(scene, edge)};
        frame.view.numbers = HdrNumbers::Full;
        frame.view.samples = 1;
        return frame;
    }

    LinearFrame sliced(const ChosenFrame& frame) {
        IncrementalCapture capture(*renderer, source_, frame);
        steps_ = 1;
        for (Result<bool> done = capture.step(noPatience); done && !*done;
             done = capture.step(noPatience)) {
            ++steps_;
        }
        const auto made = capture.frame();
        EXPECT_TRUE(made) << (made ? "" : made.error().text());
        return made ? *made : LinearFrame();
    }

    /// Draws the frame at once, with an exposure of 0.
    LinearFrame whole(const ChosenFrame& frame) {
        const auto image = renderer->capture(frame.scene, frame.view, source_, false);
        EXPECT_TRUE(image);
        LinearFrame made;
        made.size = {image->width, image->height};
        for (std::size_t i = 0; i + 3 < image->pixels.size(); i += 4) {
            made.colors.emplace_back(image->pixels[i], image->pixels[i + 1], image->pixels[i + 2]);
        }
        return made;
    }

    MeshSource source_;
    int steps_ = 0;
};

TEST_F(IncrementalCaptureTest, Frame_IsTheOneThatIsDrawnAtOnce) {
    Scene scene = simpleScene("phong");
    scene.lights.push_back(light("point"));
    const ChosenFrame frame = frameOf(scene, 256);
    EXPECT_EQ(sliced(frame), whole(frame));
    EXPECT_GT(steps_, 2);
}

TEST_F(IncrementalCaptureTest, EnvironmentsLight_IsSummedUpToTheEnd) {
    Scene scene = simpleScene("lambert");
    scene.setPart(kinds::environment, block("environment", "studio"));
    ChosenFrame frame = frameOf(scene, 24);
    frame.view.environmentSamples = 300; // more than one frame may have
    const LinearFrame made = sliced(frame);
    EXPECT_EQ(renderer->job().environmentSamples(), 300);
    EXPECT_EQ(made, whole(frame));
}

TEST_F(IncrementalCaptureTest, GivenUp_LeavesTheNextFrameAsItIs) {
    const ChosenFrame frame = frameOf(simpleScene("phong"), 256);
    const LinearFrame right = whole(frame);
    {
        IncrementalCapture given(*renderer, source_, frameOf(simpleScene("ward"), 256));
        ASSERT_TRUE(given.step(noPatience));
    }
    EXPECT_EQ(sliced(frame), right);
}

TEST_F(IncrementalCaptureTest, ErrorsInPieces_AreThoseOfTheWholeFrame) {
    const Scene scene = simpleScene("phong");
    LinearFrame right = whole(frameOf(scene, 256));
    right.counts.assign(right.colors.size(), 1);
    LinearFrame other = right;
    for (std::size_t i = 0; i < other.colors.size(); i += 3) {
        other.colors[i] *= 1.01;
    }
    ParallelJob preparing;
    const DisplayCurve curve = DisplayCurve::of(scene, *catalog);
    const ErrorMeter meter(right, curve, preparing);
    int steps = 0;
    while (!preparing.step(noPatience)) {
        ++steps;
    }
    ParallelJob comparing;
    FrameError error;
    meter.addErrorOf(comparing, other, error);
    while (!comparing.step(noPatience)) {
        ++steps;
    }
    EXPECT_GT(steps, 50);
    EXPECT_EQ(error, ErrorMeter(right, curve).errorOf(other));
    EXPECT_GT(error.flip, 0.0);
    EXPECT_NEAR(error.p99, 0.01, 1e-9);
}

TEST_F(IncrementalCaptureTest, StepOf512Pixels_IsShorterThanAWindowMayWait) {
    Scene scene = simpleScene("cook-torrance");
    scene.setPart(kinds::environment, block("environment", "studio"));
    ChosenFrame frame = frameOf(scene, 512);
    frame.view.environmentSamples = 8;
    sliced(frame); // makes the programs
    frame.view.environmentSamples = 64;
    IncrementalCapture capture(*renderer, source_, frame);
    EXPECT_LT(longestOf([&] { return capture.step(patience).value(); }), longestMs);

    LinearFrame right = capture.frame().value();
    right.counts.assign(right.colors.size(), 1);
    const LinearFrame other = right;
    ParallelJob work;
    const ErrorMeter meter(right, DisplayCurve::of(scene, *catalog), work);
    EXPECT_LT(longestOf([&] { return work.step(patience); }), longestMs);
    FrameError error;
    meter.addErrorOf(work, other, error);
    EXPECT_LT(longestOf([&] { return work.step(patience); }), longestMs);
}

} // namespace
} // namespace patina::incremental_capture_test
