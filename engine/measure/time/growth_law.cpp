// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/time/growth_law.h"

#include <algorithm>
#include <cmath>

namespace patina {
namespace {

constexpr std::size_t minSamples = 3;
constexpr double constantBelow = 1.1; ///< is a GrowthLaw::spread
constexpr double linearFrom = 0.99;   ///< is a GrowthLaw::fit

struct Weighted {
    double x = 0.0;
    double y = 0.0;
    double weight = 1.0;
};

struct Line {
    double base = 0.0;
    double slope = 0.0;
    double fit = 1.0;
};

/// Returns the line of weighted least squares, computed about the means to keep the digits of small
/// slopes.
Line lineThrough(const std::vector<Weighted>& points) {
    double all = 0.0;
    double meanX = 0.0;
    double meanY = 0.0;
    for (const Weighted& point : points) {
        all += point.weight;
        meanX += point.weight * point.x;
        meanY += point.weight * point.y;
    }
    meanX /= all;
    meanY /= all;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const Weighted& point : points) {
        xx += point.weight * (point.x - meanX) * (point.x - meanX);
        xy += point.weight * (point.x - meanX) * (point.y - meanY);
        yy += point.weight * (point.y - meanY) * (point.y - meanY);
    }
    const double slope = xx > 0.0 ? xy / xx : 0.0;
    return {meanY - slope * meanX, slope, yy > 0.0 ? slope * xy / yy : 1.0};
}

} // namespace

GrowthLaw::Shape GrowthLaw::shape() const {
    if (spread < constantBelow) {
        return Shape::Constant;
    }
    return fit >= linearFrom ? Shape::Linear : Shape::Power;
}

double GrowthLaw::at(double count) const {
    return shape() == Shape::Power ? scale * std::pow(count, exponent) : base + each * count;
}

std::optional<GrowthLaw> growthLaw(const std::vector<GrowthSample>& samples) {
    std::vector<Weighted> plain;
    std::vector<Weighted> logarithms;
    double shortest = HUGE_VAL;
    double longest = 0.0;
    for (const GrowthSample& sample : samples) {
        const double time = sample.milliseconds.median;
        if (!(time > 0.0) || !(sample.count > 0.0)) {
            return std::nullopt;
        }
        plain.push_back({sample.count, time, 1.0 / (time * time)});
        logarithms.push_back({std::log(sample.count), std::log(time), 1.0});
        shortest = std::min(shortest, time);
        longest = std::max(longest, time);
    }
    if (samples.size() < minSamples) {
        return std::nullopt;
    }
    const Line line = lineThrough(plain);
    const Line power = lineThrough(logarithms);
    return GrowthLaw{line.base,   line.slope,           line.fit,
                     power.slope, std::exp(power.base), longest / shortest};
}

} // namespace patina
