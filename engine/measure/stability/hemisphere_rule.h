// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// Is a node of a hemisphereRule(): a direction above the surface, and its share of the light that
/// a matte surface reflects.
struct WeightedDirection {
    glm::dvec3 v;
    double weight = 0.0;
};

/// Says how fine a hemisphereRule() is.
struct HemisphereRuleSize {
    int nodes = 6;             ///< counts Gauss-Legendre nodes of each panel, along each angle
    double widestPanel = 0.25; ///< radians
};

/// Returns viewers all over the hemisphere about the normal (0, 0, 1). The sum of weight times a
/// model's value, over n.l, is the directional albedo for light from `l`, the integral of f (n.v).
/// The rule is composite Gauss-Legendre in elevation and azimuth; panels shrink by steps towards
/// the mirror direction (to 0.0005 rad, for lobes as narrow as that of an exponent of 100 000),
/// towards the horizon and the light.
std::vector<WeightedDirection> hemisphereRule(const glm::dvec3& l,
                                              const HemisphereRuleSize& size = {});

} // namespace patina
