// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/median_interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace patina {
namespace {

constexpr double confidence = 0.95;

/// Returns how many samples may be cut off at each end: the binomial chance that at most so many of
/// `count` samples lie on one side of the median must stay below half of 1 - `confidence`. It uses
/// logarithms, since the chance that none does underflows for very many samples.
std::size_t cutOff(std::size_t count) {
    double logChance = -static_cast<double>(count) * std::numbers::ln2;
    double below = std::exp(logChance);
    std::size_t cut = 0;
    while (below <= 0.5 * (1.0 - confidence)) {
        ++cut;
        logChance += std::log(static_cast<double>(count - cut + 1) / static_cast<double>(cut));
        below += std::exp(logChance);
    }
    return cut == 0 ? 0 : cut - 1;
}

} // namespace

MedianInterval medianInterval(std::vector<double> samples) {
    if (samples.empty()) {
        return {};
    }
    std::sort(samples.begin(), samples.end());
    const std::size_t count = samples.size();
    const std::size_t cut = cutOff(count);
    const double median = 0.5 * (samples[(count - 1) / 2] + samples[count / 2]);
    return {median, samples[cut], samples[count - 1 - cut]};
}

} // namespace patina
