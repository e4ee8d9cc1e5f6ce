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

/// Says where the ground's disk lies.
struct GroundPlace {
    glm::dvec3 middle{0.0};
    double radius = 1.0; ///< metres
};

/// Finds what stands on the ground, and so where it lies.
class GroundUnder {
  public:
    /// Adds an object: a box of its own space, its way into the world, its lowest height there.
    void add(const Bounds& bounds, const glm::dmat4& world, double lowest);

    /// Nothing where there is no ground, nothing on it, or it is not seen because the eye is below.
    std::optional<GroundPlace> place(const Ground& ground, const glm::dvec3& eye) const;

  private:
    glm::dvec3 lower_{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper_{-std::numeric_limits<double>::infinity()};
    double lowest_ = std::numeric_limits<double>::infinity();
};

/// Adds what the ground needs to the depths of what is drawn.
void addGround(DepthRange& depths, const GroundPlace& place, const Camera& camera);

/// Leads from a square of two metres a side, level at the origin, into the world.
glm::dmat4 worldMatrix(const GroundPlace& place);

/// Returns that square, and its box.
Mesh groundMesh();
Bounds groundBounds();

/// Returns the lowest height of a mesh in the world. Exact: a box's corners lie lower than what is
/// in it when it is turned.
double lowestPoint(const MeshView& mesh, const glm::dmat4& world);

} // namespace patina
