// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/paired_frames.h"

#include <algorithm>
#include <utility>

namespace patina {
namespace {

/// Beside a frame of so long it is nothing what programs take to be made.
constexpr double slowMilliseconds = 5000.0;

} // namespace

PairedFrames::PairedFrames(TimedFrames& frames, const ChosenFrame& exact, const ChosenFrame& other,
                           const Limits& limits, const MedianInterval& empty)
    : frames_(frames), exact_(exact), other_(other), limits_(limits),
      pairs_(limits.pairs, empty) {}

double PairedFrames::spent() const {
    return std::chrono::duration<double>(Clock::now() - began_).count();
}

double PairedFrames::nextTime() {
    const ChosenFrame& frame = exactTime_ ? other_ : exact_;
    return frames_.timeOf(frame.scene, frame.view);
}

void PairedFrames::addPair(double exact, double other) {
    pairs_.add(exact, other);
    exactTimes_.push_back(exact);
}

bool PairedFrames::step() {
    const double time = nextTime();
    if (!exactTime_) {
        exactTime_ = time;
        return false;
    }
    const double exact = *std::exchange(exactTime_, std::nullopt);
    const bool isSlow = spent() > limits_.most * limits_.seconds;
    if (isWarm_ || std::min(exact, time) > slowMilliseconds) {
        addPair(exact, time);
    }
    isWarm_ = true;
    const bool isEnough = pairs_.runs() >= limits_.pairs.fewest;
    return pairs_.runs() > 0 &&
           (isSlow || pairs_.finished() || (isEnough && spent() > limits_.seconds));
}

} // namespace patina
