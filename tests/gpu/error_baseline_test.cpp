// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/error_baseline.h"

#include "environment_fixture.h"
#include "measure/error/incremental_capture.h"

namespace patina::error_baseline_test {
namespace {

constexpr const char* choice = "picture.environment";

class ErrorBaselineTest : public EnvironmentTest {
  protected:
    void SetUp() override {
        EnvironmentTest::SetUp();
        size_ = 12;
        scene_ = inTheStudio("lambert");
    }

    ChosenFrame frameWith(int directions) const {
        ChosenFrame frame{scene_, viewWith(scene_, directions)};
        frame.view.numbers = HdrNumbers::Full;
        return frame;
    }

    /// Of a picture whose finest frame has so many directions.
    std::unique_ptr<ErrorBaseline> baselineOf(int directions) {
        auto baseline = std::make_unique<ErrorBaseline>(
            GroundTruthFrame::Wish{
                *renderer, source_, frameWith(directions), frameWith(directions), {true}, false},
            choice);
        while (!baseline->isDone()) {
            EXPECT_TRUE(baseline->step(std::chrono::milliseconds(10)));
        }
        return baseline;
    }

    LinearFrame drawn(const ChosenFrame& frame) {
        IncrementalCapture capture(*renderer, source_, frame);
        while (!*capture.step(std::chrono::milliseconds(10))) {
        }
        return *capture.frame();
    }

    Scene scene_;
    MeshSource source_ = squares();
};

TEST_F(ErrorBaselineTest, FewerDirections_AreComparedWithOthersThanTheirOwn) {
    const auto baseline = baselineOf(256);
    const std::optional<ConvergedRender> render = baseline->converged();
    ASSERT_TRUE(render);
    EXPECT_EQ(render->directions, 256);
    EXPECT_GT(render->noise.p99, 0.0);
    EXPECT_GT(render->finest.p99, 0.2 * render->noise.p99); // which is no part of the render
    EXPECT_LT(render->finest.p99, 5.0 * render->noise.p99);
    const FrameError few =
        baseline->meterOf({{choice, "16"}}).errorOf(drawn(frameWith(16)));
    EXPECT_GT(few.p99, 3.0 * render->noise.p99);
}

TEST_F(ErrorBaselineTest, OtherChoices_AreComparedWithTheSameDirections) {
    const auto baseline = baselineOf(32);
    ChosenFrame half = frameWith(32);
    half.view.numbers = HdrNumbers::Half;
    const FrameError error = baseline->meterOf({{"picture.numbers", "half"}}).errorOf(drawn(half));
    EXPECT_GT(error.p99, 0.0);
    EXPECT_LT(error.p99, 2e-3); // half floats have eleven bits
    EXPECT_GT(baseline->converged()->noise.p99, 5e-3);
}

TEST_F(ErrorBaselineTest, SeriesOfDirections_HaveTheSameMeanAndNothingElseInCommon) {
    ChosenFrame other = frameWith(64);
    other.view.environmentSeries = 1;
    const LinearFrame a = drawn(frameWith(64));
    const LinearFrame b = drawn(other);
    double difference = 0.0;
    double sum = 0.0;
    for (std::size_t i = 5 * 12 + 4; i < 5 * 12 + 8; ++i) { // on the square
        EXPECT_NE(a.colors[i], b.colors[i]);
        difference += a.colors[i].g - b.colors[i].g;
        sum += a.colors[i].g;
    }
    EXPECT_LT(std::abs(difference), 0.1 * sum);
}

} // namespace
} // namespace patina::error_baseline_test
