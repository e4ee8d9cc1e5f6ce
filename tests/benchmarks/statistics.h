// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace patina::benchmarks {

/// Middle value and the range that holds the middle half.
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

/// "12.3 ms (11.9 .. 13.0)"
inline std::string text(const Spread& spread, double scale, const std::string& unit) {
    return fmt::format("{:.3g} {} ({:.3g} .. {:.3g})", spread.median * scale, unit,
                       spread.lower * scale, spread.upper * scale);
}

/// One printed row: what was measured, the figure, and the most it may be.
inline void report(const std::string& what, const std::string& figure, bool kept,
                   const std::string& target) {
    fmt::print("{:<44} {:<44} {:<6} {}\n", what, figure, kept ? "kept" : "MISSED", target);
}

} // namespace patina::benchmarks
