// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "measure/time/median_interval.h"

namespace patina {

/// Holds the time that a number of things takes.
struct GrowthSample {
    double count = 0.0; ///< counts pixels, lights or objects; more than 0
    MedianInterval milliseconds;
    int runs = 0; ///< counts timed frames; 0: the times are given, not measured

    bool isSure() const { return haveInterval(runs); }

    friend bool operator==(const GrowthSample&, const GrowthSample&) = default;
};

/// Says how a time grows with a count: t = base + each * count by least squares of the relative
/// errors, and t ~ count^exponent by a line through the logarithms.
struct GrowthLaw {
    double base = 0.0; ///< milliseconds
    double each = 0.0; ///< milliseconds for one
    double fit = 0.0;  ///< is R^2 of the straight line, by the same weights; at most 1
    double exponent = 0.0;
    double scale = 0.0;  ///< milliseconds of one, by the exponent
    double spread = 1.0; ///< is the longest time over the shortest

    enum class Shape { Constant, Linear, Power };
    /// Returns Constant where the times differ by less than a tenth, Linear where the line explains
    /// 99 % of their variance, and Power otherwise.
    Shape shape() const;

    /// Returns the milliseconds of a count, by the straight line, or by the exponent where that
    /// fits badly.
    double at(double count) const;

    friend bool operator==(const GrowthLaw&, const GrowthLaw&) = default;
};

/// Returns the law of samples with different counts; nothing for fewer than three, or for times or
/// counts that are not above 0.
std::optional<GrowthLaw> growthLaw(const std::vector<GrowthSample>& samples);

} // namespace patina
