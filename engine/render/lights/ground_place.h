// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/mesh.h"
#include "render/lights/frustum.h"
#include "scene/scene.h"

namespace patina {

/// Says where the ground's disk lies in world space.
struct GroundPlace {
    glm::dvec3 middle{0.0};
    double radius = 1.0; ///< metres
};

/// Collects the objects that stand on the ground, to place the ground under them.
class GroundUnder {
  public:
    /// Adds an object: a box of its own space, its transform into the world, and its lowest height
    /// in the world.
    void add(const Bounds& bounds, const glm::dmat4& world, double lowest);

    /// Returns where the ground lies; nothing when it is off, when no object (or too large a scene)
    /// stands on it, or when the eye is below it.
    std::optional<GroundPlace> place(const Ground& ground, const glm::dvec3& eye) const;

  private:
    glm::dvec3 lower_{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper_{-std::numeric_limits<double>::infinity()};
    double lowest_ = std::numeric_limits<double>::infinity();
};

/// Adds the depths of the ground to those of what is drawn.
void addGround(DepthRange& depths, const GroundPlace& place, const Camera& camera);

/// Returns the transform of groundMesh() into the world.
glm::dmat4 worldMatrix(const GroundPlace& place);

/// Returns a level square of two metres a side around the origin; groundBounds() is its box.
Mesh groundMesh();
Bounds groundBounds();

/// Returns the lowest height of a mesh in the world. It looks at all vertices of a rotated mesh,
/// because the corners of a rotated box lie lower than the mesh.
double lowestPoint(const MeshView& mesh, const glm::dmat4& world);

} // namespace patina
