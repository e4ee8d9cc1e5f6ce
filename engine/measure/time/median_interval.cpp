// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/median_interval.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace patina {
namespace {

constexpr double confidence = 0.95;

/// Returns how many samples may be cut off at each end: the most k for which the chance that at
/// most k of n fair coins show heads stays below half of what may be missed. By logarithms: of very
/// many coins the chance that none does is no number of its own.
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
