// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "measure/lobe/lobe_model.h"
#include "measure/lobe/lobe_scale.h"

namespace patina {

/// Is the reflectance over the angle of the half vector from the normal, to the right, and that of
/// the light from the half vector, upwards, with the plane of light and viewer across that of
/// normal and half vector (Rusinkiewicz, A New Change of Variables for Efficient BRDF
/// Representation, 1998, at a difference azimuth of 90 degrees). Both are above the surface
/// everywhere. The left edge is the mirror's peak over the angle of incidence, the right one the
/// horizon; the lower edge looks back at the light.
struct HalfDifferenceSlice {
    int size = 0;                  ///< cells along each side; a cell is taken at its middle
    std::vector<glm::dvec3> cells; ///< are rows of f in 1/sr, from the bottom up

    const glm::dvec3& at(int half, int difference) const {
        return cells[static_cast<std::size_t>(difference * size + half)];
    }
    /// Returns the middle of a cell along a side, in radians.
    double angleOf(int cell) const;
};

/// Returns the slice with so many cells along each side.
HalfDifferenceSlice halfDifferenceSlice(const LobeModel& model, int size);

/// Returns the value in 1/sr that is white in a picture of slices: one cell of twenty has as much
/// in its strongest channel. Near a highlight and the horizon a few have a thousand times as much,
/// and all others would be black beside them. 0 where all are 0.
double whiteOf(std::span<const HalfDifferenceSlice* const> slices);

/// Returns the colour of a cell on a screen, each channel 0 .. 1: f as light, or on a scale that is
/// steeper for what is dark.
glm::dvec3 shownColor(const glm::dvec3& f, LobeScale scale, double white);

} // namespace patina
