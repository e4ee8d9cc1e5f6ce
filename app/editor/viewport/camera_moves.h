// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "core/mesh.h"
#include "scene/scene.h"

namespace patina {

/// Returns the camera turned around its pivot, by angles in degrees; the pitch stops at the poles.
Camera orbited(const Camera& camera, double yaw, double pitch);

/// Returns the camera moved so that what is at the pivot's depth follows the pointer by `pixels` (x
/// to the right, y down) in a view of `height` pixels.
Camera panned(const Camera& camera, const glm::dvec2& pixels, double height);

/// Returns the camera with its distance multiplied; it stays within 1e-3 .. 1e5 metres.
Camera dollied(const Camera& camera, double factor);

/// Returns dollied() moved sideways so that the point at the pivot's depth under `place` (pixels
/// from the top left) stays there in a view of `size` pixels.
Camera zoomedTo(const Camera& camera, double factor, const glm::dvec2& place,
                const glm::dvec2& size);

/// Returns the camera with another field of view (degrees), at such a distance that as much is seen
/// at the pivot as before.
Camera withLens(const Camera& camera, double fieldOfView);

/// Degrees; the lines of sight then differ from the axis of the view by half a degree at most,
/// so that parallel lines look parallel.
inline constexpr double orthographicLens = 1.0;

/// Pairs an object with its mesh; both outlive it.
struct PlacedMesh {
    const Object& object;
    MeshView mesh;
};

/// Returns the camera moved, without a turn, so that the objects are in the middle of the view and
/// fill all but a margin of it; the pivot is as deep as the middles of their boxes on average.
/// `aspect` is width over height. Empty meshes do not count; where all are empty it returns
/// `camera`.
Camera framed(const Camera& camera, std::span<const PlacedMesh> objects, double aspect);
Camera framed(const Camera& camera, const Object& object, const MeshView& mesh, double aspect);

/// Tells whether two cameras show the same picture, apart from rounding errors.
bool isSameView(const Camera& a, const Camera& b);

/// Returns the camera turned to look at another pivot from where its eye is; `camera` where the
/// pivot is nearer than 1 mm to the eye.
Camera pivotedAt(const Camera& camera, const glm::dvec3& pivot);

/// Returns an axis of the camera in world space, a unit vector: the one to the right or the one
/// upwards.
glm::dvec3 rightOf(const Camera& camera);
glm::dvec3 upOf(const Camera& camera);

} // namespace patina
