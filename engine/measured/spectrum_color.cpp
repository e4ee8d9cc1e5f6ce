// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/spectrum_color.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

namespace patina {
namespace {

/// Returns a bell around `middle` whose width differs on both sides, in nm.
double bell(double wavelength, double middle, double left, double right) {
    const double x = (wavelength - middle) / (wavelength < middle ? left : right);
    return std::exp(-0.5 * x * x);
}

/// Returns the colour matching functions X, Y and Z.
glm::dvec3 matching(double nm) {
    return {1.056 * bell(nm, 599.8, 37.9, 31.0) + 0.362 * bell(nm, 442.0, 16.0, 26.7) -
                0.065 * bell(nm, 501.1, 20.4, 26.2),
            0.821 * bell(nm, 568.8, 46.9, 40.5) + 0.286 * bell(nm, 530.9, 16.3, 31.1),
            1.217 * bell(nm, 437.0, 11.8, 36.0) + 0.681 * bell(nm, 459.0, 26.0, 13.8)};
}

constexpr glm::dvec3 daylightWhite{0.95047, 1.0, 1.08883}; ///< XYZ of D65

/// Turns XYZ into linear Rec. 709 (IEC 61966-2-1), column by column.
const glm::dmat3 toRec709{glm::dvec3(3.2404542, -0.9692660, 0.0556434),
                          glm::dvec3(-1.5371385, 1.8760108, -0.2040259),
                          glm::dvec3(-0.4985314, 0.0415560, 1.0572252)};

constexpr int firstWavelength = 380; ///< nm, as the last one
constexpr int lastWavelength = 730;

/// Returns what the channels see of each nanometre; each channel adds up to 1.
std::vector<glm::dvec3> seenByNanometre() {
    std::vector<glm::dvec3> seen;
    glm::dvec3 sum(0.0);
    for (int nm = firstWavelength; nm <= lastWavelength; ++nm) {
        seen.push_back(glm::max(toRec709 * matching(nm), glm::dvec3(0.0)));
        sum += seen.back();
    }
    for (glm::dvec3& each : seen) {
        each /= sum;
    }
    return seen;
}

/// Moves each wavelength to the mean of the light that is nearest to it. Returns how far the
/// farthest one moved, in nm.
double moveToMeans(std::vector<WavelengthShare>& nodes, const std::vector<glm::dvec3>& seen) {
    double farthest = 0.0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double end = i + 1 < nodes.size()
                               ? 0.5 * (nodes[i].wavelength + nodes[i + 1].wavelength)
                               : lastWavelength;
        glm::dvec3 shares(0.0);
        double moment = 0.0;
        for (; next < seen.size() && firstWavelength + double(next) <= end; ++next) {
            shares += seen[next];
            moment += (seen[next].x + seen[next].y + seen[next].z) *
                      (firstWavelength + double(next));
        }
        const double weight = shares.x + shares.y + shares.z;
        const double mean = weight > 0.0 ? moment / weight : nodes[i].wavelength;
        farthest = std::max(farthest, std::abs(mean - nodes[i].wavelength));
        nodes[i] = {mean, shares};
    }
    return farthest;
}

} // namespace

std::vector<WavelengthShare> wavelengthShares(int count) {
    const std::vector<glm::dvec3> seen = seenByNanometre();
    const auto nodes = static_cast<std::size_t>(std::clamp(count, 1, 100));
    double whole = 0.0;
    for (const glm::dvec3& each : seen) {
        whole += std::sqrt(each.x + each.y + each.z);
    }
    // Begins near the end: many lie where much is seen.
    std::vector<WavelengthShare> found;
    double before = 0.0;
    for (std::size_t i = 0; i < seen.size() && found.size() < nodes; ++i) {
        before += std::sqrt(seen[i].x + seen[i].y + seen[i].z);
        if (before * double(nodes) >= (double(found.size()) + 0.5) * whole) {
            found.push_back({firstWavelength + double(i), glm::dvec3(0.0)});
        }
    }
    constexpr int maxRounds = 1000;
    for (int i = 0; i < maxRounds && moveToMeans(found, seen) > 1e-9; ++i) {
    }
    return found;
}

std::vector<glm::dvec3> spectrumWeights(std::span<const float> wavelengths) {
    std::vector<glm::dvec3> weights;
    glm::dvec3 sum(0.0);
    const std::size_t last = wavelengths.empty() ? 0 : wavelengths.size() - 1;
    for (std::size_t i = 0; i < wavelengths.size(); ++i) {
        const double before = wavelengths[i == 0 ? 0 : i - 1];
        const double after = wavelengths[std::min(i + 1, last)];
        const double width = wavelengths.size() == 1 ? 1.0 : 0.5 * (after - before);
        weights.push_back(width * matching(wavelengths[i]));
        sum += weights.back();
    }
    for (glm::dvec3& weight : weights) {
        for (int c = 0; c < 3; ++c) {
            weight[c] = sum[c] > 0.0 ? weight[c] / sum[c] * daylightWhite[c] : 0.0;
        }
        weight = toRec709 * weight;
    }
    return weights;
}

} // namespace patina
