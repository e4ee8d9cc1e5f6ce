// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <vector>

#include "core/steps.h"
#include "measure/choice/choices.h"
#include "measure/time/choice_cost.h"
#include "measure/time/timed_frames.h"

namespace patina {

/// Times a frame beside the exact one, a frame per step. Both stay as they are meanwhile.
class PairedFrames {
  public:
    struct Limits {
        CostPairs::Options pairs{};
        double seconds = 1.0; ///< after so long the fewest pairs are enough,
        double longest = 3.0; ///< and after so long those that there are
    };

    /// `empty`: milliseconds of the frame without what is shaded.
    PairedFrames(TimedFrames& frames, const ChosenFrame& exact, const ChosenFrame& other,
                 const Limits& limits, const MedianInterval& empty);

    PairedFrames(const PairedFrames&) = delete;
    PairedFrames& operator=(const PairedFrames&) = delete;

    /// True when no more frames are wanted.
    bool step() {
        run_.step();
        return run_.isDone();
    }

    double progress() const; ///< 0 .. 1; may end before, where times settle

    ChoiceCost cost() const { return pairs_.cost(); }

    /// Returns milliseconds of the exact frame, pair by pair.
    const std::vector<double>& exactTimes() const { return exactTimes_; }

  private:
    using Clock = std::chrono::steady_clock;

    Steps run();
    double timeOf(const ChosenFrame& frame);
    double warmUp(const ChosenFrame& frame);
    void addPair(double exact, double other);
    bool isEnough() const;
    double spent() const;

    TimedFrames& frames_;
    const ChosenFrame& exact_;
    const ChosenFrame& other_;
    Limits limits_;
    CostPairs pairs_;
    Clock::time_point began_ = Clock::now();
    std::vector<double> exactTimes_;
    Steps run_;
};

} // namespace patina
