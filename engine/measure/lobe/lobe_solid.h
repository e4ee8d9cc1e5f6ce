// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "measure/lobe/polar_curve.h"

namespace patina {

/// Says how fine the mesh of a lobe is.
struct SolidFineness {
    int rings = 44;    ///< from the mirror direction to the horizon
    int segments = 64; ///< about the mirror direction
};

/// Is the reflectance over all viewers above the surface, as a mesh of directions: rings about the
/// direction that the light is mirrored to, which are closer next to it, so that a narrow lobe
/// keeps its peak. The first ring is that direction alone, the last one the horizon.
struct LobeSolid {
    SolidFineness fineness;
    std::vector<glm::dvec3> directions; ///< unit, ring by ring
    std::vector<glm::dvec3> f;          ///< 1/sr, as many

    /// Returns the place of a direction; segments go round.
    std::size_t place(int ring, int segment) const {
        return static_cast<std::size_t>(ring) * static_cast<std::size_t>(fineness.segments) +
               static_cast<std::size_t>(segment % fineness.segments);
    }
};

/// Returns the lobe for light from a direction. Lobes of the same light and fineness have the same
/// directions.
LobeSolid lobeSolid(const LobeModel& model, const Incoming& incoming,
                    const SolidFineness& fineness = {});

} // namespace patina
