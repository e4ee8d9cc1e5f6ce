// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/slider_range.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace patina {

namespace {

/// Returns the value rounded to a multiple of 10^exponent. It divides by an exact power, which
/// keeps 0.3 at 0.3.
double rounded(double value, int exponent) {
    const double power = std::pow(10.0, std::abs(exponent));
    return exponent < 0 ? std::round(value * power) / power : std::round(value / power) * power;
}

} // namespace

SliderRange::SliderRange(const Parameter& parameter)
    : lower_(parameter.softMin), upper_(parameter.softMax), softMin_(parameter.softMin),
      softMax_(parameter.softMax), min_(parameter.min), max_(parameter.max),
      step_(parameter.step > 0.0 ? parameter.step : 0.01), isWhole_(infoOf(parameter.type).isWhole),
      scale_(parameter.scale) {
    if (!(softMin_ < softMax_)) { // no slider to speak of; any length will do
        upper_ = softMax_ = softMin_ + 1.0;
    }
}

void SliderRange::widenFor(double value) {
    if (value > upper_) {
        upper_ = std::min(max_, value + std::abs(value));
    } else if (value < lower_) {
        lower_ = std::max(min_, value - std::abs(value));
    }
}

void SliderRange::reset() {
    lower_ = softMin_;
    upper_ = softMax_;
}

/// Returns the distance from the start of a log slider above which it is logarithmic; below it is
/// almost linear. For one that starts at or below 0 this is the start of its soft range or, where
/// that is not above 0, a thousandth of the range's length. How far it was widened does not matter.
double SliderRange::kneeOfLog() const {
    if (lower_ > 0.0) {
        return lower_;
    }
    return softMin_ > 0.0 ? softMin_ : (softMax_ - softMin_) * 1e-3;
}

double SliderRange::positionOf(double value) const {
    const double inside = std::clamp(value, lower_, upper_);
    if (scale_ == Scale::Linear) {
        return (inside - lower_) / (upper_ - lower_);
    }
    const double knee = kneeOfLog();
    return std::log1p((inside - lower_) / knee) / std::log1p((upper_ - lower_) / knee);
}

double SliderRange::continued(double position) const {
    if (scale_ == Scale::Linear) {
        return lower_ + position * (upper_ - lower_);
    }
    const double knee = kneeOfLog();
    return lower_ + knee * std::expm1(position * std::log1p((upper_ - lower_) / knee));
}

double SliderRange::valueAt(double position) const {
    return continued(std::clamp(position, 0.0, 1.0));
}

double SliderRange::tidied(double value, double change) const {
    const int exponent = static_cast<int>(std::floor(std::log10(change)));
    return rounded(value, isWhole_ ? std::max(exponent, 0) : exponent);
}

double SliderRange::tidyValueAt(double position, double span) const {
    const double value = valueAt(position);
    const double change = std::abs(valueAt(position + span) - valueAt(position - span)) / 2.0;
    if (position <= 0.0 || position >= 1.0 || !(change > 0.0)) {
        return isWhole_ ? std::round(value) : value;
    }
    return std::clamp(tidied(value, change), lower_, upper_);
}

bool SliderRange::isInHardRange(double position) const {
    const double value = continued(position);
    return value >= min_ && value <= max_;
}

double SliderRange::continuedValueAt(double position, double span) const {
    const double value = std::clamp(continued(position), min_, max_);
    const double change = std::abs(continued(position + span) - continued(position - span)) / 2.0;
    const bool canRound = std::isfinite(change) && change > 0.0 && isInHardRange(position);
    return canRound ? std::clamp(tidied(value, change), min_, max_) : value;
}

/// Returns the nearest multiple of the shortest round number of steps that is no shorter than
/// `change`.
double SliderRange::snapped(double value, double change) const {
    const double wanted = std::isfinite(change) ? change / step_ : 1.0;
    double power = 1.0;
    while (10.0 * power < wanted) {
        power *= 10.0;
    }
    const auto counts = {1.0, 2.0, 5.0, 10.0};
    const auto* const count = std::find_if(counts.begin(), std::prev(counts.end()),
                                           [&](double number) { return number * power >= wanted; });
    const double apart = *count * power * step_;
    return stepped(std::round(value / apart) * apart, 0.0);
}

double SliderRange::snappedValueAt(double position, double span) const {
    const double half = span / 2.0;
    const double inside = std::clamp(position, half, 1.0 - half);
    const double change = valueAt(inside + half) - valueAt(inside - half);
    return std::clamp(snapped(valueAt(position), change), lower_, upper_);
}

double SliderRange::continuedSnapAt(double position, double span) const {
    const double half = span / 2.0;
    return snapped(std::clamp(continued(position), min_, max_),
                   continued(position + half) - continued(position - half));
}

double SliderRange::stepped(double value, double steps) const {
    const double next = value + steps * step_;
    // Adding 0.1 again and again must not show 0.30000000000000004, nor one step from a value that
    // was kept as a float 0.29900002.
    constexpr int floatDigits = 6;
    const auto exponentOf = [](double number) {
        return static_cast<int>(std::floor(std::log10(number)));
    };
    const int step = exponentOf(step_);
    const int last = next != 0.0 ? exponentOf(std::abs(next)) - floatDigits : step;
    const int exponent = std::clamp(last, step - floatDigits, step - 2);
    return std::clamp(rounded(next, std::min(exponent, 0)), min_, max_);
}

} // namespace patina
