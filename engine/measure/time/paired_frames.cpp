// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/paired_frames.h"

#include <algorithm>
#include <utility>

namespace patina {
namespace {

/// Beside a frame of so long it is nothing what programs take to be made.
constexpr double slowMilliseconds = 5000.0;

/// More than those after which frames look for the model's lobe.
constexpr int warmingDirections = 16;

} // namespace

PairedFrames::PairedFrames(TimedFrames& frames, const ChosenFrame& exact, const ChosenFrame& other,
                           const Limits& limits, const MedianInterval& empty)
    : frames_(frames), exact_(exact), other_(other), limits_(limits),
      pairs_(limits.pairs, empty) {}

double PairedFrames::spent() const {
    return std::chrono::duration<double>(Clock::now() - began_).count();
}

double PairedFrames::progress() const {
    const double byPairs = double(pairs_.runs()) / double(limits_.pairs.most);
    return std::min(std::max(byPairs, spent() / limits_.seconds), 1.0);
}

/// What only warms up needs no more directions of an environment than make the programs and targets
/// of the frame.
double PairedFrames::nextTime() {
    const ChosenFrame& frame = exactTime_ ? other_ : exact_;
    if (isWarm_ || frame.view.environmentSamples <= warmingDirections) {
        return frames_.timeOf(frame.scene, frame.view);
    }
    View view = frame.view;
    view.environmentSamples = warmingDirections;
    frames_.timeOf(frame.scene, view);
    return 0.0;
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
    const bool isSlow = spent() > limits_.longest;
    if (isWarm_ || std::min(exact, time) > slowMilliseconds) {
        addPair(exact, time);
    }
    isWarm_ = true;
    const bool isEnough = pairs_.runs() >= limits_.pairs.fewest;
    return pairs_.runs() > 0 &&
           (isSlow || pairs_.finished() || (isEnough && spent() > limits_.seconds));
}

} // namespace patina
