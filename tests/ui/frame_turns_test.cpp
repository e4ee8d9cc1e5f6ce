// SPDX-License-Identifier: GPL-3.0-or-later
// Several views whose frames take long share one device.
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <QTest>

#include "viewport/frame_turns.h"

namespace patina::tests::frame_turns_test {
namespace {

constexpr int limitMs = 5000;

/// Writes the letter of each frame whose turn it is; a frame leaves after its turns.
class Turns : public testing::Test {
  protected:
    struct Frame {
        int left;
        std::unique_ptr<FrameTurns::Place> place{};
    };

    void add(Frame& frame, char letter) {
        frame.place = std::make_unique<FrameTurns::Place>(turns_, [this, &frame, letter] {
            order_ += letter;
            if (--frame.left == 0) {
                frame.place->leave();
            }
        });
    }

    /// Returns whose turns there were, in their order.
    std::string afterTurns(std::size_t count) {
        EXPECT_TRUE(QTest::qWaitFor([&] { return order_.size() >= count; }, limitMs)) << order_;
        QTest::qWait(1);
        return order_;
    }

  private:
    FrameTurns turns_;
    std::string order_;
};

TEST_F(Turns, OfSeveralFrames_FinishOneAfterTheOther) {
    Frame a{3};
    Frame b{2};
    add(a, 'a');
    add(b, 'b');
    a.place->take(Urgency::Frame);
    b.place->take(Urgency::Frame);
    EXPECT_EQ(afterTurns(5), "aaabb");
}

TEST_F(Turns, OfASketch_ComeBeforeWholeFramesAndThoseBeforeMoreSamples) {
    Frame samples{2};
    Frame whole{2};
    Frame sketch{2};
    add(samples, 's');
    add(whole, 'w');
    add(sketch, 'k');
    samples.place->take(Urgency::Refinement);
    whole.place->take(Urgency::Frame);
    sketch.place->take(Urgency::Sketch);
    EXPECT_EQ(afterTurns(6), "kkwwss");
}

TEST_F(Turns, AskedForAgain_AreThoseOfOthersFirst) {
    Frame a{2};
    Frame b{2};
    add(a, 'a');
    add(b, 'b');
    a.place->take(Urgency::Frame);
    b.place->take(Urgency::Frame);
    a.place->take(Urgency::Frame); // another frame of the same view
    EXPECT_EQ(afterTurns(4), "bbaa");
}

TEST_F(Turns, OfAViewThatGoes_LeaveThoseOfOthers) {
    Frame a{2};
    Frame b{2};
    add(a, 'a');
    add(b, 'b');
    a.place->take(Urgency::Frame);
    b.place->take(Urgency::Frame);
    a.place.reset();
    EXPECT_EQ(afterTurns(2), "bb");
}

} // namespace
} // namespace patina::tests::frame_turns_test
