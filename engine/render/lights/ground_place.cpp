// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/ground_place.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/lights/shadow_view.h"

namespace patina {
namespace {

/// The radius of the ground is this many times half the diagonal of the objects.
constexpr double groundReach = 12.0;

/// The ground lies below the lowest point of the objects by this share of their size.
constexpr double lieBelow = 5e-4;

/// metres; a ground under a larger scene would leave no usable precision of depths
constexpr double largestScene = 1e9;

} // namespace

void GroundUnder::add(const Bounds& bounds, const glm::dmat4& world, double lowest) {
    for (int corner = 0; !bounds.empty() && corner < 8; ++corner) {
        const glm::dvec3 x(world * cornerOf(bounds, corner));
        lower_ = glm::min(lower_, x);
        upper_ = glm::max(upper_, x);
    }
    lowest_ = std::min(lowest_, lowest);
}

std::optional<GroundPlace> GroundUnder::place(const Ground& ground, const glm::dvec3& eye) const {
    const double size = 0.5 * glm::length(upper_ - lower_);
    // A little lower, so that a flat mesh that lies on it is seen.
    const double height = ground.automatic ? lowest_ - lieBelow * size : ground.height;
    const bool isUsable = lower_.x <= upper_.x && 2.0 * size < largestScene;
    if (ground.mode == GroundMode::Off || !isUsable || !(eye.y > height)) {
        return std::nullopt;
    }
    return GroundPlace{{0.5 * (lower_.x + upper_.x), height, 0.5 * (lower_.z + upper_.z)},
                       groundReach * std::max(size, 1e-6)};
}

void addGround(DepthRange& depths, const GroundPlace& place, const Camera& camera) {
    const glm::dvec3 from = eye(camera);
    const glm::dvec3 middle(viewMatrix(camera) * glm::dvec4(place.middle, 1.0));
    depths.add(0.2 * (from.y - place.middle.y));
    depths.add(-middle.z + 1.5 * place.radius);
    depths.addReach(glm::length(middle) + place.radius);
}

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
    mesh.bounds = groundBounds();
    return mesh;
}

Bounds groundBounds() {
    Bounds bounds;
    bounds.add({-1.0f, 0.0f, -1.0f});
    bounds.add({1.0f, 0.0f, 1.0f});
    return bounds;
}

double lowestPoint(const MeshView& mesh, const glm::dmat4& world) {
    const glm::dvec3 up(world[0][1], world[1][1], world[2][1]);
    double lowest = 0.0;
    if ((up.x != 0.0) + (up.y != 0.0) + (up.z != 0.0) <= 1) {
        for (int axis = 0; axis < 3; ++axis) {
            lowest +=
                std::min(up[axis] * mesh.bounds.lower[axis], up[axis] * mesh.bounds.upper[axis]);
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
