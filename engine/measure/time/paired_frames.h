// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <vector>

#include "core/steps.h"
#include "measure/choice/choices.h"
#include "measure/time/choice_cost.h"
#include "measure/time/timed_frames.h"

namespace patina {

/// Times a frame and the exact one in turn, one frame per step. Both must not change meanwhile.
class PairedFrames {
  public:
    struct Limits {
        CostPairs::Options pairs{};
        double seconds = 1.0; ///< seconds after which the fewest pairs are enough
        double longest = 3.0; ///< seconds after which any pairs are enough
    };

    /// Takes the milliseconds of a frame without anything to shade as `empty`.
    PairedFrames(TimedFrames& frames, const ChosenFrame& exact, const ChosenFrame& other,
                 const Limits& limits, const MedianInterval& empty);

    PairedFrames(const PairedFrames&) = delete;
    PairedFrames& operator=(const PairedFrames&) = delete;

    /// Times one frame, and returns true when no more frames are needed.
    bool step() {
        run_.step();
        return run_.isDone();
    }

    double progress() const; ///< 0 .. 1; may stop below 1, where times settle

    ChoiceCost cost() const { return pairs_.cost(); }

    /// Returns the milliseconds of the exact frame in each pair.
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
