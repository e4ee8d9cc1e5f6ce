// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/paired_frames.h"

#include <algorithm>

namespace patina {
namespace {

/// Is the time of a frame beside which that of making its programs is negligible.
constexpr double slowMilliseconds = 5000.0;

/// Is above the number of directions from which on frames use other programs for the model's lobe.
constexpr int warmingDirections = 16;

} // namespace

PairedFrames::PairedFrames(TimedFrames& frames, const ChosenFrame& exact, const ChosenFrame& other,
                           const Limits& limits, const MedianInterval& empty)
    : frames_(frames), exact_(exact), other_(other), limits_(limits), pairs_(limits.pairs, empty),
      run_(run()) {}

double PairedFrames::spent() const {
    return std::chrono::duration<double>(Clock::now() - began_).count();
}

double PairedFrames::progress() const {
    const double byPairs = double(pairs_.runs()) / double(limits_.pairs.max);
    return std::min(std::max(byPairs, spent() / limits_.seconds), 1.0);
}

double PairedFrames::timeOf(const ChosenFrame& frame) {
    return frames_.timeOf(frame.scene, frame.view);
}

/// Draws the frame once, so that its programs and targets are made. Returns its milliseconds, or 0
/// where it was drawn with fewer directions of an environment to save time.
double PairedFrames::warmUp(const ChosenFrame& frame) {
    if (frame.view.environmentSamples <= warmingDirections) {
        return timeOf(frame);
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

bool PairedFrames::isEnough() const {
    const bool hasMin = pairs_.runs() >= limits_.pairs.min;
    return pairs_.runs() > 0 && (spent() > limits_.longest || pairs_.finished() ||
                                 (hasMin && spent() > limits_.seconds));
}

/// Warms up both frames, whose times count only where they are slow, and then times pairs.
Steps PairedFrames::run() {
    const double warmExact = warmUp(exact_);
    co_yield Steps::Pause();
    const double warmOther = warmUp(other_);
    if (std::min(warmExact, warmOther) > slowMilliseconds) {
        addPair(warmExact, warmOther);
    }
    while (!isEnough()) {
        co_yield Steps::Pause();
        const double exact = timeOf(exact_);
        co_yield Steps::Pause();
        addPair(exact, timeOf(other_));
    }
}

} // namespace patina
