// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/choice_cost.h"

#include <algorithm>

namespace patina {
namespace {

/// Returns the least time that can be told from nothing, in milliseconds: the interval of empty
/// frames, but no less than the clock's resolution.
double noiseOf(const MedianInterval& empty) {
    constexpr double clock = 1e-4;
    return std::max(empty.upper - empty.lower, clock);
}

/// Returns the time of shading in a frame, or the most that it may be where it is below the noise.
double shadingTime(double frame, const MedianInterval& empty) {
    return std::max(frame - empty.median, noiseOf(empty));
}

} // namespace

void CostPairs::add(double exact, double other) {
    ratios_.push_back(shadingTime(other, empty_) / shadingTime(exact, empty_));
    exactBelowNoise_ += exact - empty_.median < noiseOf(empty_) ? 1 : 0;
    belowNoise_ += other - empty_.median < noiseOf(empty_) ? 1 : 0;
}

bool CostPairs::isSettled(const MedianInterval& ratio) const {
    return int(ratios_.size()) >= options_.min && 2 * exactBelowNoise_ <= runs() &&
           ratio.upper - ratio.lower < options_.width * ratio.median;
}

bool CostPairs::finished() const {
    return int(ratios_.size()) >= options_.max || isSettled(medianInterval(ratios_));
}

ChoiceCost CostPairs::cost() const {
    ChoiceCost cost;
    cost.ratio = medianInterval(ratios_);
    cost.runs = int(ratios_.size());
    cost.settled = isSettled(cost.ratio);
    cost.belowNoise = 2 * belowNoise_ > cost.runs;
    return cost;
}

RatioBound boundOf(const ChoiceCost& cost, const ChoiceCost& from) {
    if (from.belowNoise) {
        return cost.belowNoise ? RatioBound::Unknown : RatioBound::AtLeast;
    }
    return cost.belowNoise ? RatioBound::AtMost : RatioBound::None;
}

ChoiceCost withTimes(ChoiceCost cost, const ExactFrame& exact) {
    const double shading = shadingTime(exact.milliseconds, exact.empty);
    const auto milliseconds = [&](double ratio) {
        return exact.milliseconds + (ratio - 1.0) * shading;
    };
    cost.milliseconds = {milliseconds(cost.ratio.median), milliseconds(cost.ratio.lower),
                         milliseconds(cost.ratio.upper)};
    if (exact.pixels > 0) {
        cost.nanosecondsPerPixel = 1e6 * shading * cost.ratio.median / double(exact.pixels);
    }
    return cost;
}

} // namespace patina
