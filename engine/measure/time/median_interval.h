// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace patina {

/// Represents a median and where the true one lies.
struct MedianInterval {
    double median = 0.0;
    double lower = 0.0;
    double upper = 0.0;

    bool contains(double value) const { return lower <= value && value <= upper; }

    friend bool operator==(const MedianInterval&, const MedianInterval&) = default;
};

/// So few samples have no interval of 95 %.
constexpr int minForInterval = 6;

/// Tells whether so many samples have one; 0: the numbers are given, not measured.
constexpr bool haveInterval(int samples) {
    return samples == 0 || samples >= minForInterval;
}

/// Returns the median of samples with an interval that holds the true one with a probability of at
/// least 95 %, whatever the samples' distribution: by order statistics, David and Nagaraja 2003,
/// 7.1. With fewer than six samples, where there is no such interval, from the least to the
/// greatest. All 0 for no samples.
MedianInterval medianInterval(std::vector<double> samples);

} // namespace patina
