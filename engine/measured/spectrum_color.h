// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// Returns for each of these wavelengths (nm, rising) what its value adds to linear Rec. 709: the
/// colour that the CIE's observer of 1931 sees (Wyman, Sloan and Shirley 2013), scaled so that a
/// spectrum of ones is white. Weights may be below 0.
std::vector<glm::dvec3> spectrumWeights(std::span<const float> wavelengths);

/// Is light of one wavelength that stands for what lies around it.
struct WavelengthShare {
    double wavelength = 0.0; ///< nm
    /// Are its shares of what red, green and blue see; over all wavelengths each adds up to 1.
    glm::dvec3 shares{0.0};

    friend bool operator==(const WavelengthShare&, const WavelengthShare&) = default;
};

/// Returns so many wavelengths, rising, that stand for all of 380 to 730 nm, 1 <= count <= 100.
/// Each stands for the light that is nearest to it and is the mean of that, weighted by what the
/// channels see (S. P. Lloyd, Least Squares Quantization in PCM, IEEE Trans. Inf. Theory 28(2),
/// 1982). What a channel sees is the colour that spectrumWeights() knows with its negative parts
/// cut off, since no display shows pure colours; so no share is below 0.
std::vector<WavelengthShare> wavelengthShares(int count);

} // namespace patina
