// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "render/lights/environment_light.h"

namespace patina {

/// Is a lamp in an environment: the light above a limit from a small part of all directions.
struct EnvironmentLamp {
    glm::dvec3 direction{0.0}; ///< is a unit vector towards the lamp, in the environment's own
                               ///< space
    glm::dvec3 radiance{0.0};  ///< is E / pi on a surface that faces it, linear
    double width = 0.0;        ///< radians: the angle across a disc of the same solid angle
};

/// Holds the lamps of an environment, the strongest first. The light above `limit` comes from the
/// lamps; without lamps the limit is 0.
struct EnvironmentLamps {
    double limit = 0.0; ///< luminance
    std::vector<EnvironmentLamp> lamps;
};

/// Finds the sun and other lamps: at most four compact parts of the sky that together send all the
/// light above a limit. The lowest such limit is taken, so that the lamps have as much of the light
/// as possible.
EnvironmentLamps environmentLamps(const EnvironmentRadiance& environment);

} // namespace patina
