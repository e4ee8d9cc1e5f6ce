// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec3.hpp>

#include "catalog/block.h"
#include "scene/scene.h"

namespace patina {

/// Says how far a light can be seen, by what its descriptor says of its reach.
struct LightReach {
    glm::dvec3 from{0.0};
    double range = 0.0; ///< metres; 0: without end
    glm::dvec3 axis{0.0};
    double angle = 0.0; ///< radians between the axis and the side; 0: no cone

    bool isEverywhere() const { return !(range > 0.0) && !(angle > 0.0); }
};

/// Returns how far a light of the block reaches. A value that is missing or not finite bounds
/// nothing. Allocates nothing.
LightReach reachOf(const Light& light, const Block& block);

} // namespace patina
