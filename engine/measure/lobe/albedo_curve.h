// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "measure/lobe/adaptive_integral.h"
#include "measure/lobe/polar_curve.h"

namespace patina {

/// Is the directional albedo for light from one angle.
struct AlbedoPoint {
    double angle = 0.0;     ///< radians from the normal
    glm::dvec3 albedo{0.0}; ///< is the share of the light that is reflected; more than 1 is a gain
    double uncertainty = 0.0; ///< is how far it may be off
};

/// Returns the directional albedo, the integral of f (n.v) over all viewers, within the tolerance
/// where so many panels reach it. It is integrated in rings about the mirror direction, whose radii
/// are spread by the logarithm from 1e-5 radians on, so that broad and narrow lobes cost alike; a
/// narrower lobe than that is missed. Where `isWanted` becomes false the value means nothing.
AlbedoPoint directionalAlbedo(
    const LobeModel& model, const Incoming& incoming, const IntegralAim& aim = {},
    const std::function<bool()>& isWanted = [] { return true; });

/// Returns angles for a curve of the albedo, in radians: even steps of this many degrees and closer
/// ones towards maxIncoming.
std::vector<double> albedoAngles(double stepDegrees);

/// Returns the albedo over the light's angle, computed on all cores. `isWanted` is asked in
/// the midst of each point, on any thread, and the curve ends where it is not.
std::vector<AlbedoPoint> albedoCurve(
    const LobeModel& model, double azimuth, std::span<const double> angles,
    const IntegralAim& aim = {}, const std::function<bool()>& isWanted = [] { return true; });

/// Is what a material reflects of all the light, per channel.
struct EnergyRange {
    glm::dvec3 min{0.0};  ///< over the light's angle
    glm::dvec3 mean{0.0}; ///< of a uniform white sky: over the angle by its cosine
    glm::dvec3 max{0.0};  ///< over the light's angle
};

/// Returns the range of a curve of two points or more.
EnergyRange energyRange(std::span<const AlbedoPoint> curve);

} // namespace patina
