// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/lobe_solid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace patina {
namespace {

/// Is the ratio's logarithm of the last ring's width to the first one's.
constexpr double spread = 5.0;

/// Returns the share of the way to the horizon at which a ring lies.
double ringShare(int ring, int rings) {
    return std::expm1(spread * ring / rings) / std::expm1(spread);
}

} // namespace

LobeSolid lobeSolid(const LobeModel& model, const Incoming& incoming,
                    const SolidFineness& fineness) {
    Incoming lit = incoming;
    lit.angle = std::clamp(incoming.angle, 0.0, maxIncoming);
    const glm::dvec3 light = lit.direction();
    const glm::dvec3 mirror = lit.across(lit.angle);
    const glm::dvec3 side(-std::sin(lit.azimuth), std::cos(lit.azimuth), 0.0);
    const glm::dvec3 ahead = glm::cross(side, mirror);
    LobeSolid solid{fineness, {}, {}};
    for (int ring = 0; ring <= fineness.rings; ++ring) {
        for (int segment = 0; segment < fineness.segments; ++segment) {
            const double turn = 2.0 * std::numbers::pi * segment / fineness.segments;
            const glm::dvec3 away = std::cos(turn) * ahead + std::sin(turn) * side;
            const double horizon = std::atan2(mirror.z, -away.z);
            const double radius = horizon * ringShare(ring, fineness.rings);
            glm::dvec3 v = std::cos(radius) * mirror + std::sin(radius) * away;
            // On the horizon nothing is reflected, and rounding would put some of it below itself.
            const glm::dvec3 seen =
                glm::normalize(glm::dvec3(v.x, v.y, std::max(v.z, std::cos(maxIncoming))));
            v.z = std::max(v.z, 0.0);
            solid.directions.push_back(v);
            solid.f.push_back(model.reflectance(light, seen));
        }
    }
    return solid;
}

} // namespace patina
