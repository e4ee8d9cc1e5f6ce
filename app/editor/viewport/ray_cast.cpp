// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/ray_cast.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace patina {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Distance along the ray to a triangle (Moeller and Trumbore 1997), or infinity.
double distanceTo(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 edge1 = b - a;
    const glm::dvec3 edge2 = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, edge2);
    const double determinant = glm::dot(edge1, p);
    if (determinant == 0.0) {
        return never;
    }
    const glm::dvec3 s = ray.origin - a;
    const double u = glm::dot(s, p) / determinant;
    const glm::dvec3 q = glm::cross(s, edge1);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) {
        return never;
    }
    const double t = glm::dot(edge2, q) / determinant;
    return t > 0.0 ? t : never;
}

/// Tells whether the ray comes through the box before `limit`. The slabs' ends are rounded, so a
/// little more than the box counts.
bool meets(const Ray& ray, const Bounds& box, double limit) {
    constexpr double slack = 1e-12;
    double enter = 0.0;
    double leave = limit;
    for (int axis = 0; axis < 3; ++axis) {
        const double toLower = double(box.lower[axis]) - ray.origin[axis];
        const double toUpper = double(box.upper[axis]) - ray.origin[axis];
        if (ray.direction[axis] == 0.0) {
            leave = toLower <= 0.0 && toUpper >= 0.0 ? leave : -never;
            continue;
        }
        const double one = toLower / ray.direction[axis];
        const double other = toUpper / ray.direction[axis];
        enter = std::max(enter, std::min(one, other));
        leave = std::min(leave, std::max(one, other));
    }
    return leave >= 0.0 && enter <= leave * (1.0 + slack);
}

/// The nearest of some triangles in object space; the ray's direction need not be a unit vector
/// there, so that distances are the world's.
double distanceTo(const Ray& ray, std::span<const Vertex> vertices,
                  std::span<const std::uint32_t> indices) {
    const auto corner = [&](std::size_t i) { return glm::dvec3(vertices[indices[i]].position); };
    double nearest = never;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        nearest = std::min(nearest, distanceTo(ray, corner(i), corner(i + 1), corner(i + 2)));
    }
    return nearest;
}

double distanceTo(const Ray& ray, const PickMesh& pick) {
    const MeshView& mesh = pick.mesh;
    if (pick.runs.empty()) {
        return distanceTo(ray, mesh.vertices, mesh.indices);
    }
    constexpr std::size_t perRun = 3 * trianglesPerRun;
    double nearest = never;
    for (std::size_t run = 0; run < pick.runs.size(); ++run) {
        if (meets(ray, pick.runs[run], nearest)) {
            const std::size_t first = run * perRun;
            const auto triangles =
                mesh.indices.subspan(first, std::min(perRun, mesh.indices.size() - first));
            nearest = std::min(nearest, distanceTo(ray, mesh.vertices, triangles));
        }
    }
    return nearest;
}

Ray inObjectSpace(const Ray& ray, const Object& object) {
    const glm::dmat4 inverse = glm::inverse(worldMatrix(object));
    return {glm::dvec3(inverse * glm::dvec4(ray.origin, 1.0)),
            glm::dvec3(inverse * glm::dvec4(ray.direction, 0.0))};
}

} // namespace

Ray rayThrough(const Camera& camera, const glm::dvec2& place, const glm::dvec2& size) {
    const double tangent = std::tan(0.5 * glm::radians(camera.fieldOfView));
    const double x = (2.0 * place.x / size.x - 1.0) * tangent * size.x / size.y;
    const double y = (1.0 - 2.0 * place.y / size.y) * tangent;
    const glm::dmat4 toWorld = glm::inverse(viewMatrix(camera));
    return {eye(camera), glm::normalize(glm::dvec3(toWorld * glm::dvec4(x, y, -1.0, 0.0)))};
}

std::optional<Hit> cast(const Ray& ray, const Scene& scene,
                        const std::function<PickMesh(const Object&)>& meshes) {
    Hit hit{-1, never, {}};
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (!object.visible) {
            continue;
        }
        const double distance = distanceTo(inObjectSpace(ray, object), meshes(object));
        if (distance < hit.distance) {
            hit = {static_cast<int>(i), distance, ray.origin + distance * ray.direction};
        }
    }
    return hit.object < 0 ? std::nullopt : std::optional(hit);
}

} // namespace patina
