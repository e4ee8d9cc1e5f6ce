// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "render/lights/environment_light.h"

namespace patina {

/// Represents a lamp in an environment: what a small part of all directions sends above a limit.
struct EnvironmentLamp {
    glm::dvec3 direction{0.0}; ///< unit, towards it, in the environment's own space
    glm::dvec3 radiance{0.0};  ///< E / pi on a surface that faces it, linear
    double width = 0.0;        ///< radians: how wide a disc of its size looks
};

/// Holds the lamps of an environment, the strongest first, and the limit above which its light is
/// theirs. Without lamps the limit is 0.
struct EnvironmentLamps {
    double limit = 0.0; ///< luminance
    std::vector<EnvironmentLamp> lamps;
};

/// Finds the sun and the lamps: compact parts that are brighter than what is around them, at most
/// four, which together have all the light above the limit. The lowest such limit is taken, so that
/// most of their light is theirs.
EnvironmentLamps environmentLamps(const EnvironmentRadiance& environment);

} // namespace patina
