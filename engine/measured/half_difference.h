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

} // namespace patina
