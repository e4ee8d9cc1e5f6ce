// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/spectrum_color.h"

#include <algorithm>
#include <cmath>

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

} // namespace

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
