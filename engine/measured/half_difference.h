// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measured/measured_reflectance.h"

namespace patina {

/// Holds Rusinkiewicz' angles of a pair of directions (1998), in radians.
struct HalfDifference {
    double half = 0.0;       ///< 0 .. pi/2: between normal and half vector
    double difference = 0.0; ///< 0 .. pi/2: between half vector and light
    double azimuth = 0.0;    ///< of the light around the half vector; 0 .. pi where both ways are
                             ///< the same
};

/// Returns the angles of two directions above the surface.
HalfDifference halfDifference(const DirectionPair& pair);

/// Returns the directions with these angles whose half vector lies over the tangent; they may be
/// below the surface.
DirectionPair directionsAt(const HalfDifference& angles);

/// Returns the number of an index of the sequence of van der Corput in a base, 0 .. 1.
double radicalInverse(std::size_t index, std::size_t base);

/// Returns the pair of directions of an index, 1 or more, of Halton's sequence over their half
/// vector (by the root of its angle, so dense around the normal), the light around it, and the turn
/// of both around the normal. One may be below the surface.
DirectionPair spreadPair(std::size_t index);

} // namespace patina
