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

} // namespace patina
