// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "material/material.h"

namespace patina {

/// Holds the optical constants of a material over the wavelength of light in vacuum.
struct IndexSpectrum {
    std::vector<double> wavelengths; ///< nanometres, rising
    std::vector<double> index;       ///< as many
    std::vector<double> extinction;  ///< as many; empty: the medium is clear
    std::vector<double> reflectance; ///< as many: the share that is mirrored facing the surface
    /// Are the wavelengths of red, green and blue, in nanometres: those of a scene that names none,
    /// where the term has none of its own.
    glm::dvec3 channels{0.0};
    /// Says that the constants are known at the channels' wavelengths alone, and are taken to go
    /// straight from one to the next.
    bool isOfChannels = false;
};

/// Returns the spectrum of a material's Fresnel term: over 380 .. 780 nm and its channels where it
/// is known there. It is an error where the term knows no index, or has no code in double
/// precision.
Result<IndexSpectrum> indexSpectrum(const Catalog& catalog, const Material& material);

} // namespace patina
