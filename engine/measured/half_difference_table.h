// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "core/table_number.h"

namespace patina {

/// Counts the azimuths of the half vector for which a table with a grain has a slice, from the
/// tangent on, towards the bitangent. shaders/models/measured-grain.glsl counts the same.
inline constexpr int grainTurns = 60;

/// Holds the reflectance of a surface in bins over the angles of halfDifference(), as the MERL
/// collection's files do: the azimuth over 0 .. pi, the difference angle over 0 .. pi/2, and the
/// square root of the half angle's share of pi/2. A value belongs to the middle of its bin.
///
/// With a grain there is such a table for each of `grainTurns` azimuths of the half vector, side by
/// side along all three axes. Each has its azimuth's other end at both ends, and ends in bins in
/// which nothing was measured: a mean over neighbours never takes any of another azimuth.
struct HalfDifferenceTable {
    /// Is the largest number of bins along an axis, which every graphics card has room for.
    static constexpr int maxBins = 2048;
    /// Is the largest number of bins of all, 96 MiB.
    static constexpr std::size_t maxTexels = std::size_t(1) << 23;

    glm::ivec3 bins{1}; ///< counts those of azimuth, difference angle and half angle
    /// Are f in 1/sr for linear Rec. 709, the azimuth quickest and the half angle slowest. Where
    /// red is below 0 nothing was measured.
    std::vector<glm::vec3> texels{glm::vec3(0.0f)};
    TableForm form = TableForm::WithoutGrain;
    bool isIsotropic = true; ///< tells whether the surface has no grain, whatever the form
};

} // namespace patina
