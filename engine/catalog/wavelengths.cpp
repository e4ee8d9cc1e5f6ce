// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/wavelengths.h"

#include <algorithm>

#include "catalog/block_kind.h"

namespace patina {

double nmInUnit(const Parameter& wavelengths) {
    return wavelengths.unit == "nm" ? 1.0 : 1e-3;
}

void takeWavelengths(const Parameter& parameter, const glm::dvec3& ofScene, double* numbers) {
    if (parameter.role != roles::wavelengths || parameter.type != ParameterType::Vec3) {
        return;
    }
    const double unit = nmInUnit(parameter);
    for (int channel = 0; channel < 3; ++channel) {
        if (!(numbers[channel] >= minWavelength * unit)) {
            numbers[channel] = std::max(ofScene[channel], minWavelength) * unit;
        }
    }
}

double movedWavelength(double wavelength, const glm::dvec3& ofScene) {
    const glm::dvec3& from = srgbWavelengths;
    const int upper = wavelength > from.y ? 0 : 1; // red and green, or green and blue
    const double share = std::clamp(
        (wavelength - from[upper + 1]) / (from[upper] - from[upper + 1]), 0.0, 1.0);
    const double anchor = from[upper + 1] + share * (from[upper] - from[upper + 1]);
    const double moved = ofScene[upper + 1] + share * (ofScene[upper] - ofScene[upper + 1]);
    return std::max(wavelength + (moved - anchor), minWavelength);
}

} // namespace patina
