// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/mesh.h"

namespace patina {

/// Where the ground's disk lies.
struct GroundPlace {
    glm::dvec3 middle{0.0};
    double radius = 1.0; ///< metres
};

/// From a square of two metres a side, level at the origin, into the world.
glm::dmat4 worldMatrix(const GroundPlace& place);

/// That square.
Mesh groundMesh();

/// The lowest height of a mesh in the world. Exact: a box's corners lie lower than what is in it
/// when it is turned.
double lowestPoint(const MeshView& mesh, const glm::dmat4& world);

} // namespace patina
