// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/place_beside.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "resources/mesh_library.h"

namespace patina {
namespace {

/// Is the space between two objects, as a share of the new one's width.
constexpr double gap = 0.1;

/// Is the coarsest step that places are rounded to, as a share of the new object's size. Boxes of
/// meshes are no more precise, as they are floats.
constexpr double finest = 1e-5;

/// Is a box in world space, in metres.
struct Box {
    glm::dvec3 lower{std::numeric_limits<double>::max()};
    glm::dvec3 upper{std::numeric_limits<double>::lowest()};

    bool isEmpty() const { return lower.x > upper.x; }

    void add(const Object& object, const Bounds& bounds) {
        if (bounds.empty()) {
            return;
        }
        const glm::dmat4 world = worldMatrix(object);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec4 local((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                                   (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                                   (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z, 1.0);
            const glm::dvec3 place(world * local);
            lower = glm::min(lower, place);
            upper = glm::max(upper, place);
        }
    }
};

glm::dvec3 rounded(const glm::dvec3& place, double size) {
    const double step = std::pow(10.0, std::floor(std::log10(finest * size)));
    return glm::round(place / step) * step + 0.0; // turns -0.0 into 0.0
}

} // namespace

Object placedBeside(const Scene& scene, const Object& object, MeshLibrary& meshes) {
    return placedBeside(scene, std::vector<Object>{object}, meshes).front();
}

std::vector<Object> placedBeside(const Scene& scene, std::vector<Object> objects,
                                 MeshLibrary& meshes) {
    Box there;
    for (const Object& each : scene.objects) {
        if (each.visible) {
            there.add(each, meshes.view(each).bounds);
        }
    }
    Box own;
    for (const Object& each : objects) {
        own.add(each, meshes.view(each).bounds);
    }
    if (there.isEmpty() || own.isEmpty()) {
        return objects;
    }
    const glm::dvec3 extent = own.upper - own.lower;
    const double size = std::max({extent.x, extent.y, extent.z});
    if (!(size > 0.0)) {
        return objects;
    }
    const glm::dvec3 way{there.upper.x - own.lower.x + gap * extent.x, there.lower.y - own.lower.y,
                         0.5 * (there.lower.z + there.upper.z - own.lower.z - own.upper.z)};
    for (Object& each : objects) {
        each.translation = rounded(each.translation + way, size);
    }
    return objects;
}

} // namespace patina
