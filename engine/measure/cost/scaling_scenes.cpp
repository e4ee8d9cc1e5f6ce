// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/scaling_scenes.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace patina {
namespace {

/// Holds the camera's right and up in world space.
struct Facing {
    glm::dvec3 right;
    glm::dvec3 up;
};

Facing facing(const Camera& camera) {
    const glm::dmat3 toWorld = glm::transpose(glm::dmat3(viewMatrix(camera)));
    return {toWorld[0], toWorld[1]};
}

double widestOf(const Object& object) {
    const glm::dmat3 axes(worldMatrix(object));
    return std::max({glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])});
}

} // namespace

Scene withLights(Scene scene, int count) {
    std::vector<Light> on;
    for (Light& light : scene.lights) {
        if (light.enabled) {
            light.setPart(kinds::shadows, std::nullopt);
            on.push_back(light);
        }
    }
    scene.lights.clear();
    for (int i = 0; i < count && !on.empty(); ++i) {
        scene.lights.push_back(on[static_cast<std::size_t>(i) % on.size()]);
    }
    return scene;
}

Scene withCopies(Scene scene, std::size_t object, int count) {
    const Object original = scene.objects[object];
    const Facing camera = facing(scene.camera);
    const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(double(count)))));
    const double width = 2.0 * widestOf(original);
    scene.objects.clear();
    for (int i = 0; i < count; ++i) {
        const double x = (double(i % columns) + 0.5) / columns - 0.5;
        const int row = i / columns;
        const double y = (row + 0.5) / columns - 0.5;
        Object copy = original;
        copy.scale /= double(columns);
        copy.translation += width * (x * camera.right - y * camera.up);
        scene.objects.push_back(copy);
    }
    return scene;
}

} // namespace patina
