// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include <glm/vec2.hpp>

#include "core/mesh.h"
#include "resources/pick_mesh.h"
#include "scene/scene.h"

namespace patina {

/// A half line in world space; the direction is a unit vector.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};

    friend bool operator==(const Ray&, const Ray&) = default;
};

/// A point on the surface of an object.
struct Hit {
    int object = -1; ///< index in the scene
    double distance = 0.0;
    glm::dvec3 point{0.0};

    friend bool operator==(const Hit&, const Hit&) = default;
};

/// The ray from the eye through a place in a view of `size` pixels, (0, 0) at the top left.
Ray rayThrough(const Camera& camera, const glm::dvec2& place, const glm::dvec2& size);

/// Returns the nearest visible surface that the ray meets, whichever way it faces.
std::optional<Hit> cast(const Ray& ray, const Scene& scene,
                        const std::function<PickMesh(const Object&)>& meshes);

} // namespace patina
