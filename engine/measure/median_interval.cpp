// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/median_interval.h"

#include <algorithm>
#include <cmath>

namespace patina {
namespace {

constexpr double confidence = 0.95;

/// How many samples may be cut off at each end: the most k for which the chance that at most k of
/// n fair coins show heads stays below half of what may be missed.
std::size_t cutOff(std::size_t count) {
    double chance = std::exp2(-static_cast<double>(count));
    double below = chance;
    std::size_t cut = 0;
    while (below <= 0.5 * (1.0 - confidence)) {
        ++cut;
        chance *= static_cast<double>(count - cut + 1) / static_cast<double>(cut);
        below += chance;
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
