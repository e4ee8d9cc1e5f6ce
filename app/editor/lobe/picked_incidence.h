// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "catalog/catalog.h"
#include "measure/lobe/polar_curve.h"
#include "viewport/ray_cast.h"

namespace patina {

/// Is how a place of a surface is lit and seen, in the frame of its normal (+z) and its tangent
/// (+x): unit directions to the light and to the eye.
struct PickedIncidence {
    glm::dvec3 light{0.0, 0.0, 1.0};
    glm::dvec3 viewer{0.0, 0.0, 1.0};

    Incoming incoming() const;
    /// Returns the viewer's angle from the normal in degrees, positive on the side that the light
    /// is mirrored to.
    double viewerDegrees() const;
    /// Returns how far the viewer is out of the plane of incidence, in degrees, 0 .. 90.
    double outOfPlane() const;
};

/// Returns the incidence at a place that was hit, of the light with that index; a light that is
/// with the eye comes from there. Nothing where there is no such light, and where it stands below
/// the surface.
std::optional<PickedIncidence> incidenceAt(const Hit& hit, const Scene& scene,
                                           const Catalog& catalog, const Camera& camera,
                                           std::size_t light);

} // namespace patina
