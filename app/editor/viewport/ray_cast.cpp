// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/ray_cast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "render/lights/ground_place.h"

namespace patina {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Holds a point on a triangle of a mesh.
struct Met {
    double distance = never;
    std::size_t first = 0; ///< is the position of the triangle's first index among the mesh's
    double u = 0.0;        ///< is the weight of the second corner, as v is that of the third
    double v = 0.0;
};

/// Returns where the ray meets a triangle (Moeller and Trumbore 1997); its distance is `never`
/// where it does not.
Met meet(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 edge1 = b - a;
    const glm::dvec3 edge2 = c - a;
    const glm::dvec3 p = glm::cross(ray.direction, edge2);
    const double determinant = glm::dot(edge1, p);
    if (determinant == 0.0) {
        return {};
    }
    const glm::dvec3 s = ray.origin - a;
    const double u = glm::dot(s, p) / determinant;
    const glm::dvec3 q = glm::cross(s, edge1);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) {
        return {};
    }
    const double t = glm::dot(edge2, q) / determinant;
    return {t > 0.0 ? t : never, 0, u, v};
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

/// Finds the nearest hit among `count` indices from `first` on, in object space. The ray's
/// direction need not be a unit vector there, so that distances are the world's.
void meetNearest(const Ray& ray, const MeshView& mesh, std::size_t first, std::size_t count,
                 Met& nearest) {
    const auto corner = [&](std::size_t i) {
        return glm::dvec3(mesh.vertices[mesh.indices[i]].position);
    };
    for (std::size_t i = first; i + 2 < first + count; i += 3) {
        Met met = meet(ray, corner(i), corner(i + 1), corner(i + 2));
        if (met.distance < nearest.distance) {
            met.first = i;
            nearest = met;
        }
    }
}

Met meetNearest(const Ray& ray, const PickMesh& pick) {
    const MeshView& mesh = pick.mesh;
    Met nearest;
    if (pick.runs.empty()) {
        meetNearest(ray, mesh, 0, mesh.indices.size(), nearest);
        return nearest;
    }
    constexpr std::size_t perRun = 3 * trianglesPerRun;
    for (std::size_t run = 0; run < pick.runs.size(); ++run) {
        if (meets(ray, pick.runs[run], nearest.distance)) {
            const std::size_t first = run * perRun;
            meetNearest(ray, mesh, first, std::min(perRun, mesh.indices.size() - first), nearest);
        }
    }
    return nearest;
}

/// Returns the unit normal in world space, interpolated between the vertices; that of the triangle
/// where they have none.
glm::dvec3 normalAt(const Met& met, const MeshView& mesh, const glm::dmat4& world, const Ray& ray) {
    const auto vertex = [&](std::size_t i) -> const Vertex& {
        return mesh.vertices[mesh.indices[met.first + i]];
    };
    glm::dvec3 normal = (1.0 - met.u - met.v) * glm::dvec3(vertex(0).normal) +
                        met.u * glm::dvec3(vertex(1).normal) + met.v * glm::dvec3(vertex(2).normal);
    if (!(glm::length(normal) > 0.0)) {
        const glm::dvec3 a(vertex(0).position);
        normal = glm::cross(glm::dvec3(vertex(1).position) - a, glm::dvec3(vertex(2).position) - a);
    }
    normal = glm::transpose(glm::inverse(glm::dmat3(world))) * normal;
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length)) {
        return -ray.direction;
    }
    return normal * (glm::dot(normal, ray.direction) > 0.0 ? -1.0 / length : 1.0 / length);
}

/// Returns the unit tangent in world space across the normal; zero where the vertices have none.
glm::dvec3 tangentAt(const Met& met, const MeshView& mesh, const glm::dmat4& world,
                     const glm::dvec3& normal) {
    const auto tangent = [&](std::size_t i) {
        return glm::dvec3(mesh.vertices[mesh.indices[met.first + i]].tangent);
    };
    const glm::dvec3 along = glm::dmat3(world) * ((1.0 - met.u - met.v) * tangent(0) +
                                                  met.u * tangent(1) + met.v * tangent(2));
    const glm::dvec3 across = along - glm::dot(along, normal) * normal;
    const double length = glm::length(across);
    return length > 1e-6 * glm::length(along) ? across / length : glm::dvec3(0.0);
}

Ray inObjectSpace(const Ray& ray, const Object& object) {
    const glm::dmat4 inverse = glm::inverse(worldMatrix(object));
    return {glm::dvec3(inverse * glm::dvec4(ray.origin, 1.0)),
            glm::dvec3(inverse * glm::dvec4(ray.direction, 0.0))};
}

std::optional<Hit> castOnGround(const Ray& ray, const Scene& scene, const glm::dvec3& eye,
                                const std::function<PickMesh(const Object&)>& meshes) {
    if (!isSeen(scene.ground)) {
        return std::nullopt;
    }
    GroundUnder under;
    for (const Object& object : scene.objects) {
        if (object.visible) {
            const MeshView mesh = meshes(object).mesh;
            const glm::dmat4 world = worldMatrix(object);
            under.add(mesh.bounds, world, lowestPoint(mesh, world));
        }
    }
    const std::optional<GroundPlace> place = under.place(scene.ground, eye);
    const double below = place ? place->middle.y - ray.origin.y : 0.0;
    if (!(below < 0.0) || !(ray.direction.y < 0.0)) {
        return std::nullopt; // it is met from above
    }
    const double distance = below / ray.direction.y;
    const glm::dvec3 point = ray.origin + distance * ray.direction;
    const glm::dvec3 up(0.0, 1.0, 0.0);
    return glm::distance(point, place->middle) < place->radius
               ? std::optional(Hit{-1, distance, point, up, {1.0, 0.0, 0.0}})
               : std::nullopt;
}

} // namespace

Ray rayThrough(const Camera& camera, const glm::dvec2& place, const glm::dvec2& size) {
    const double tangent = std::tan(0.5 * glm::radians(camera.fieldOfView));
    const double x = (2.0 * place.x / size.x - 1.0) * tangent * size.x / size.y;
    const double y = (1.0 - 2.0 * place.y / size.y) * tangent;
    const glm::dmat4 toWorld = glm::inverse(viewMatrix(camera));
    return {eye(camera), glm::normalize(glm::dvec3(toWorld * glm::dvec4(x, y, -1.0, 0.0)))};
}

std::optional<glm::dvec2> placeOf(const Camera& camera, const glm::dvec3& point,
                                  const glm::dvec2& size) {
    const glm::dvec3 seen(viewMatrix(camera) * glm::dvec4(point, 1.0));
    if (!(seen.z < 0.0)) {
        return std::nullopt;
    }
    const double perMetre = pixelsPerMetre(camera, point, size.y);
    return 0.5 * size + glm::dvec2(seen.x, -seen.y) * perMetre;
}

double pixelsPerMetre(const Camera& camera, const glm::dvec3& point, double height) {
    const double depth = -glm::dvec3(viewMatrix(camera) * glm::dvec4(point, 1.0)).z;
    return 0.5 * height / (depth * std::tan(0.5 * glm::radians(camera.fieldOfView)));
}

std::optional<Hit> cast(const Ray& ray, const Scene& scene,
                        const std::function<PickMesh(const Object&)>& meshes) {
    Hit hit{-1, never, {}, {}, {}};
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (!object.visible) {
            continue;
        }
        const PickMesh pick = meshes(object);
        const Met met = meetNearest(inObjectSpace(ray, object), pick);
        if (met.distance < hit.distance) {
            const glm::dmat4 world = worldMatrix(object);
            const glm::dvec3 normal = normalAt(met, pick.mesh, world, ray);
            hit = {static_cast<int>(i), met.distance, ray.origin + met.distance * ray.direction,
                   normal, tangentAt(met, pick.mesh, world, normal)};
        }
    }
    return hit.object < 0 ? std::nullopt : std::optional(hit);
}

std::optional<Hit> castWithGround(const Ray& ray, const Scene& scene, const glm::dvec3& eye,
                                  const std::function<PickMesh(const Object&)>& meshes) {
    const std::optional<Hit> object = cast(ray, scene, meshes);
    const std::optional<Hit> ground = castOnGround(ray, scene, eye, meshes);
    return object && (!ground || object->distance <= ground->distance) ? object : ground;
}

} // namespace patina
