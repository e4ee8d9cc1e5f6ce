// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "measure/time/median_interval.h"

namespace patina {

/// Holds what so many of something take.
struct GrowthSample {
    double count = 0.0; ///< pixels, lights, objects: more than 0
    MedianInterval milliseconds;
    int runs = 0; ///< that were timed; 0: the times are given, not measured

    bool isSure() const { return haveInterval(runs); }

    friend bool operator==(const GrowthSample&, const GrowthSample&) = default;
};

/// Says how a time grows with a count: t = base + each * count by least squares of the relative
/// errors, and t ~ count^exponent by a line through the logarithms.
struct GrowthLaw {
    double base = 0.0; ///< milliseconds
    double each = 0.0; ///< milliseconds for one
    double fit = 0.0;  ///< R^2 of the straight line, by the same weights; at most 1
    double exponent = 0.0;
    double scale = 0.0;  ///< milliseconds of one, by the exponent
    double spread = 1.0; ///< the longest time over the shortest

    enum class Shape { Constant, Linear, Power };
    /// Constant where the times differ by less than a tenth; linear where the line accounts for
    /// 99 % of how they differ.
    Shape shape() const;

    /// Milliseconds of so many, by the straight line, or by the exponent where that fits badly.
    double at(double count) const;

    friend bool operator==(const GrowthLaw&, const GrowthLaw&) = default;
};

/// The law of samples with different counts; nothing for fewer than three, or for times that are
/// not above 0.
std::optional<GrowthLaw> growthLaw(const std::vector<GrowthSample>& samples);

} // namespace patina
