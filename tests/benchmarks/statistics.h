// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace patina::benchmarks {

/// Holds the median and the range of the middle half.
struct Spread {
    double median = 0.0;
    double lower = 0.0;
    double upper = 0.0;
};

inline Spread spreadOf(std::vector<double> samples) {
    std::ranges::sort(samples);
    const auto at = [&](double share) {
        return samples[std::size_t(share * double(samples.size() - 1))];
    };
    return {at(0.5), at(0.25), at(0.75)};
}

/// Says how well a line fits the points: returns the coefficient of determination of y over x.
inline double straightness(const std::vector<double>& x, const std::vector<double>& y) {
    const double n = double(x.size());
    const double meanX = std::accumulate(x.begin(), x.end(), 0.0) / n;
    const double meanY = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - meanX) * (x[i] - meanX);
        xy += (x[i] - meanX) * (y[i] - meanY);
        yy += (y[i] - meanY) * (y[i] - meanY);
    }
    return xy * xy / (xx * yy);
}

/// Returns a text such as "12.3 ms (11.9 .. 13.0)".
inline std::string text(const Spread& spread, double scale, const std::string& unit) {
    return fmt::format("{:.3g} {} ({:.3g} .. {:.3g})", spread.median * scale, unit,
                       spread.lower * scale, spread.upper * scale);
}

/// Prints one row: what was measured, the figure, whether the target was kept, and the target.
inline void report(const std::string& what, const std::string& figure, bool kept,
                   const std::string& target) {
    fmt::print("{:<44} {:<44} {:<6} {}\n", what, figure, kept ? "kept" : "MISSED", target);
}

} // namespace patina::benchmarks
