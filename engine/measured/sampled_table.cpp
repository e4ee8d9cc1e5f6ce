// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/sampled_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

#include "measured/half_difference.h"

namespace patina {
namespace {

using std::numbers::pi;

constexpr glm::ivec3 sampledBins{180, 90, 90};

glm::dvec3 turned(const glm::dvec3& d, double azimuth) {
    const double c = std::cos(azimuth);
    const double s = std::sin(azimuth);
    return {d.x * c - d.y * s, d.x * s + d.y * c, d.z};
}

/// Returns the mean of both orders of the directions, which a table does not tell apart: between
/// what was measured a file's own interpolation does, by as much as it is off.
glm::vec3 meanOf(const MeasuredReflectance& measured, const DirectionPair& pair, int turns) {
    if (!(pair.l.z > 0.0 && pair.v.z > 0.0)) {
        return glm::vec3(-1.0f);
    }
    glm::dvec3 sum(0.0);
    for (int turn = 0; turn < turns; ++turn) {
        const double azimuth = 2.0 * pi * turn / turns;
        const glm::dvec3 l = turned(pair.l, azimuth);
        const glm::dvec3 v = turned(pair.v, azimuth);
        sum += measured.evaluate({l, v}) + measured.evaluate({v, l});
    }
    return glm::vec3(sum / (2.0 * turns));
}

} // namespace

HalfDifferenceTable sampledTable(const MeasuredReflectance& measured, int turns) {
    const glm::ivec3 bins = sampledBins;
    HalfDifferenceTable table;
    table.bins = bins;
    table.isWithoutGrain = turns > 1;
    table.texels.resize(std::size_t(bins.x) * std::size_t(bins.y) * std::size_t(bins.z));
    const auto fillFrom = [&](int first, int step) {
        for (int k = first; k < bins.z; k += step) {
            const double root = (k + 0.5) / bins.z;
            for (int j = 0; j < bins.y; ++j) {
                for (int i = 0; i < bins.x; ++i) {
                    const DirectionPair pair =
                        directionsAt({root * root * 0.5 * pi, (j + 0.5) / bins.y * 0.5 * pi,
                                      (i + 0.5) / bins.x * pi});
                    const auto bin = std::size_t((k * bins.y + j) * bins.x + i);
                    table.texels[bin] = meanOf(measured, pair, turns);
                }
            }
        }
    };
    const int parts = int(std::clamp(std::thread::hardware_concurrency(), 1u, 16u));
    std::vector<std::jthread> threads;
    for (int part = 1; part < parts; ++part) {
        threads.emplace_back(fillFrom, part, parts);
    }
    fillFrom(0, parts);
    threads.clear();
    return table;
}

} // namespace patina
