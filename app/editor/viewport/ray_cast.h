// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <glm/vec2.hpp>

#include "core/mesh.h"
#include "resources/pick_mesh.h"
#include "scene/scene.h"

namespace patina {

/// Holds a half line in world space; the direction is a unit vector.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};

    friend bool operator==(const Ray&, const Ray&) = default;
};

/// Holds a point on the surface of an object.
struct Hit {
    int object = -1; ///< index in the scene; -1 where nothing was hit
    double distance = 0.0;
    glm::dvec3 point{0.0};
    /// Is a unit vector, interpolated between vertices, on the side that the ray meets.
    glm::dvec3 normal{0.0};
    /// Is the unit tangent of the mesh in the surface; zero where the mesh has none.
    glm::dvec3 tangent{0.0};

    friend bool operator==(const Hit&, const Hit&) = default;
};

/// Returns the ray from the eye through a place in a view of `size` pixels, (0, 0) at the top left.
Ray rayThrough(const Camera& camera, const glm::dvec2& place, const glm::dvec2& size);

/// Returns the place of a point in a view of `size` pixels, (0, 0) at the top left; nothing where
/// it does not lie before the eye.
std::optional<glm::dvec2> placeOf(const Camera& camera, const glm::dvec3& point,
                                  const glm::dvec2& size);

/// Returns how many pixels a metre takes up at a point, in a view that is `height` pixels high.
double pixelsPerMetre(const Camera& camera, const glm::dvec3& point, double height);

/// Returns the nearest visible surface that the ray meets, whichever way it faces; nothing where
/// there is none. `meshes` returns the mesh of an object.
std::optional<Hit> cast(const Ray& ray, const Scene& scene,
                        const std::function<PickMesh(const Object&)>& meshes);

/// Does the same with the scene's ground, which `eye` sees, among the surfaces; it is no object.
std::optional<Hit> castWithGround(const Ray& ray, const Scene& scene, const glm::dvec3& eye,
                                  const std::function<PickMesh(const Object&)>& meshes);

} // namespace patina
