// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "measure/lobe/lobe_model.h"

namespace patina {

/// Says where the light comes from.
struct Incoming {
    double angle = 0.0;   ///< radians from the normal, 0 .. pi/2
    double azimuth = 0.0; ///< radians from the tangent

    glm::dvec3 direction() const; ///< is unit, towards the light
    /// Returns the unit direction in the plane of incidence at an angle from the normal, positive
    /// on the side that the light is mirrored to.
    glm::dvec3 across(double angleFromNormal) const;

    friend bool operator==(const Incoming&, const Incoming&) = default;
};

/// Is the angle of the light beyond which curves do not go, in radians: at 90 degrees a reflectance
/// is a quotient of two zeros.
inline constexpr double maxIncoming = 1.5690509975429023; // 89.9 degrees

/// Is a point of a curve over the viewer's angle.
struct LobePoint {
    double angle = 0.0; ///< radians from the normal, positive on the mirror's side
    glm::dvec3 f{0.0};  ///< 1/sr
};

/// Says how fine a curve is.
struct CurveFineness {
    int steps = 180;           ///< counts even steps from one horizon to the other
    double tolerance = 2e-3;   ///< is how far a line between points may be off, of the largest f
    std::size_t points = 1500; ///< limits how many there are
};

/// Is a value of light and viewer, which are unit directions.
using DirectionsValue = std::function<glm::dvec3(const glm::dvec3& l, const glm::dvec3& v)>;

/// Returns any value in the plane of incidence over the viewer's angle, -pi/2 .. pi/2, with points
/// that are closer where the curve bends.
std::vector<LobePoint> polarCurve(const DirectionsValue& value, const Incoming& incoming,
                                  const CurveFineness& fineness);

/// Returns the reflectance in the plane of incidence over the viewer's angle, -pi/2 .. pi/2. Points
/// are closer where the curve bends, so that a narrow lobe keeps its peak.
std::vector<LobePoint> polarCurve(const LobeModel& model, const Incoming& incoming,
                                  const CurveFineness& fineness = {});

} // namespace patina
