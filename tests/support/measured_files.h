// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "measured/measured_reflectance.h"

namespace patina::tests {

/// Returns f(l, v) in 1/sr; a negative value stands for one that was not measured.
using Reflectance = std::function<glm::dvec3(const DirectionPair&)>;

/// Returns the bytes of a MERL file with these bins of half angle, difference angle and azimuth.
std::string merlBytes(const std::array<int, 3>& bins, const Reflectance& reflectance);

/// Describes a small RGL file: normals like those of a rough surface, over which the reflectance is
/// written at the points of the file's own grid.
struct RglFile {
    int azimuths = 1; ///< 1 for an isotropic surface
    int polars = 6;
    int grid = 24;
    bool isSpectral = false; ///< writes the red channel at nine wavelengths

    std::string bytes(const Reflectance& reflectance) const;
};

} // namespace patina::tests
