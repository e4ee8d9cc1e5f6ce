// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/choice_cost.h"

#include <algorithm>

namespace patina {
namespace {

/// What shading takes of a frame; never nothing, where noise says so.
double shadingTime(double frame, double empty) {
    return std::max(frame - empty, 1e-3 * frame);
}

} // namespace

void CostPairs::add(double exact, double other) {
    const double whole = shadingTime(exact, empty_);
    ratios_.push_back(whole > 0.0 ? shadingTime(other, empty_) / whole : 1.0);
}

bool CostPairs::isSettled(const MedianInterval& ratio) const {
    return int(ratios_.size()) >= options_.fewest &&
           ratio.upper - ratio.lower < options_.width * ratio.median;
}

bool CostPairs::finished() const {
    return int(ratios_.size()) >= options_.most || isSettled(medianInterval(ratios_));
}

ChoiceCost CostPairs::cost() const {
    ChoiceCost cost;
    cost.ratio = medianInterval(ratios_);
    cost.runs = int(ratios_.size());
    cost.settled = isSettled(cost.ratio);
    return cost;
}

ChoiceCost withTimes(ChoiceCost cost, const ExactFrame& exact) {
    const double shading = shadingTime(exact.milliseconds, exact.emptyMilliseconds);
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
