// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/ground_place.h"

#include <algorithm>
#include <cmath>

namespace patina {

glm::dmat4 worldMatrix(const GroundPlace& place) {
    glm::dmat4 world(1.0);
    world[0][0] = place.radius;
    world[2][2] = place.radius;
    world[3] = glm::dvec4(place.middle, 1.0);
    return world;
}

Mesh groundMesh() {
    Mesh mesh;
    for (const glm::vec2 corner : {glm::vec2(-1, -1), {-1, 1}, {1, 1}, {1, -1}}) {
        Vertex vertex;
        vertex.position = glm::vec3(corner.x, 0.0f, corner.y);
        vertex.normal = glm::vec3(0.0f, 1.0f, 0.0f);
        vertex.uv = 0.5f * corner + 0.5f;
        mesh.vertices.push_back(vertex);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.bounds = boundsOf(mesh.vertices);
    return mesh;
}

double lowestPoint(const MeshView& mesh, const glm::dmat4& world) {
    const glm::dvec3 up(world[0][1], world[1][1], world[2][1]);
    double lowest = 0.0;
    if ((up.x != 0.0) + (up.y != 0.0) + (up.z != 0.0) <= 1) {
        for (int axis = 0; axis < 3; ++axis) {
            lowest += std::min(up[axis] * mesh.bounds.lower[axis],
                               up[axis] * mesh.bounds.upper[axis]);
        }
        return lowest + world[3][1];
    }
    lowest = 1e30;
    for (const Vertex& vertex : mesh.vertices) {
        const double height = glm::dot(up, glm::dvec3(vertex.position));
        lowest = height < lowest ? height : lowest;
    }
    return lowest + world[3][1];
}

} // namespace patina
