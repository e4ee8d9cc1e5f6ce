// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "core/mesh.h"

namespace patina {

/// Is a point of a profile: `position` is the distance from the axis and the height, `normal` the
/// unit normal that points out of the solid.
struct ProfilePoint {
    glm::dvec2 position;
    glm::dvec2 normal;
};

/// Is a smooth piece of a profile; where one span ends and the next begins the surface has an edge.
using Span = std::vector<ProfilePoint>;

/// Holds the outline of a solid of revolution about +y, from the bottom to the top.
using Profile = std::vector<Span>;

/// Returns a line from `from` to `to` in `steps` equal pieces; looking along it, the solid is to
/// the left.
Span segment(const glm::dvec2& from, const glm::dvec2& to, int steps);

/// Returns an arc about `centre`; angles in radians from +y towards the outside, normals away from
/// the centre.
Span arc(const glm::dvec2& centre, double radius, double from, double to, int steps);

/// Adds the surface of revolution of `profile` with `columns` steps around the axis. Normals are
/// the profile's, u runs once around, v along the outline by arc length, the tangent along u.
void addLathe(Mesh& mesh, const Profile& profile, int columns);

} // namespace patina
