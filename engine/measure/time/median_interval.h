// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace patina {

/// Holds a median of samples and the interval that contains the true one.
struct MedianInterval {
    double median = 0.0;
    double lower = 0.0;
    double upper = 0.0;

    bool contains(double value) const { return lower <= value && value <= upper; }

    friend bool operator==(const MedianInterval&, const MedianInterval&) = default;
};

/// Is the least number of samples that has an interval of 95 %.
constexpr int minForInterval = 6;

/// Tells whether so many samples have an interval. It is true for 0, which means that numbers are
/// given, not measured.
constexpr bool haveInterval(int samples) {
    return samples == 0 || samples >= minForInterval;
}

/// Returns the median of samples with an interval that contains the true one with a probability of
/// at least 95 %, whatever the samples' distribution: by order statistics, David and Nagaraja 2003,
/// 7.1. Fewer than six samples have no such interval: it then reaches from the least to the
/// greatest. All is 0 for no samples.
MedianInterval medianInterval(std::vector<double> samples);

} // namespace patina
