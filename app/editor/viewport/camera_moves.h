// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "core/mesh.h"
#include "scene/scene.h"

namespace patina {

/// The camera turned around its pivot, angles in degrees; the pitch stops at the poles.
Camera orbited(const Camera& camera, double yaw, double pitch);

/// The camera moved so that what is at the pivot's depth follows the pointer by `pixels`
/// (x to the right, y down) in a view of `height` pixels.
Camera panned(const Camera& camera, const glm::dvec2& pixels, double height);

/// The camera with its distance multiplied; it stays within 1e-3 .. 1e5 metres.
Camera dollied(const Camera& camera, double factor);

/// The same, while what is at `place` (pixels from the top left) of a view of `size` stays there,
/// as deep as the pivot is.
Camera zoomedTo(const Camera& camera, double factor, const glm::dvec2& place,
                const glm::dvec2& size);

/// The camera with another field of view (degrees) and as much to see at the pivot.
Camera withLens(const Camera& camera, double fieldOfView);

/// So narrow a lens shows what is parallel as parallel: lines of sight are apart by half a degree
/// at most.
inline constexpr double orthographicLens = 1.0;

/// An object and its mesh, as they stand in a scene.
struct PlacedMesh {
    const Object& object;
    MeshView mesh;
};

/// The camera moved until the objects, as they look from that side, are in the middle of the view
/// and fill it but for a little air; the pivot is as deep as the middles of their boxes on average.
/// `aspect` is width over height. Empty meshes do not count, and where there is no other nothing
/// changes.
Camera framed(const Camera& camera, std::span<const PlacedMesh> objects, double aspect);
Camera framed(const Camera& camera, const Object& object, const MeshView& mesh, double aspect);

/// Whether two cameras show the same but for rounding.
bool isSameView(const Camera& a, const Camera& b);

/// The camera with another pivot and the eye where it was.
Camera pivotedAt(const Camera& camera, const glm::dvec3& pivot);

/// Returns unit vectors of the camera in world space.
glm::dvec3 rightOf(const Camera& camera);
glm::dvec3 upOf(const Camera& camera);

} // namespace patina
