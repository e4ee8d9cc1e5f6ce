// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/placement.h"

#include <glm/geometric.hpp>

#include "render/lights/shadow_view.h"

namespace patina {
namespace {

/// Allows for the rounding of positions on their way to the screen.
constexpr double planeMargin = 1e-5;

} // namespace

Placement placementOf(const Object& object, const Bounds& bounds) {
    Placement placement;
    placement.world = worldMatrix(object);
    placement.middle = glm::dvec3(placement.world * glm::dvec4(glm::dvec3(bounds.center()), 1.0));
    for (int corner = 0; corner < 8; ++corner) {
        placement.corners[static_cast<std::size_t>(corner)] =
            glm::dvec3(placement.world * cornerOf(bounds, corner));
    }
    placement.ball = ballAround(bounds, placement.world);
    placement.instance = instanceAt(placement.world);
    return placement;
}

std::array<glm::dvec3, 8> cornersWithin(const Placement& placement, double metres) {
    std::array<glm::dvec3, 8> corners = placement.corners;
    if (!(metres > 0.0)) {
        return corners;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const glm::dvec3 along(placement.world[axis]);
        const glm::dvec3 across = glm::cross(glm::dvec3(placement.world[(axis + 1) % 3]),
                                             glm::dvec3(placement.world[(axis + 2) % 3]));
        const double size = std::abs(glm::dot(along, across)); // a sheared side leans to its edge
        const glm::dvec3 step =
            size > 0.0 ? along * (metres * glm::length(across) / size) : glm::dvec3(0.0);
        for (int corner = 0; corner < 8; ++corner) {
            corners[static_cast<std::size_t>(corner)] += (corner >> axis & 1) != 0 ? step : -step;
        }
    }
    return corners;
}

bool isOutside(const Placement& placement, const glm::dmat4& worldToClip, double metres) {
    glm::bvec4 beyond(true); // each side of the picture
    bool isBehind = true;
    for (const glm::dvec3& corner : cornersWithin(placement, metres)) {
        const glm::dvec4 x = worldToClip * glm::dvec4(corner, 1.0);
        const double w = x.w + planeMargin * std::abs(x.w);
        beyond.x = beyond.x && x.x < -w;
        beyond.y = beyond.y && x.x > w;
        beyond.z = beyond.z && x.y < -w;
        beyond.w = beyond.w && x.y > w;
        isBehind = isBehind && x.w < 0.0;
    }
    return isBehind || glm::any(beyond);
}

bool PlacementStore::Entry::isOf(const Object& object, const Bounds& box) const {
    return isKnown && translation == object.translation && rotation == object.rotation &&
           scale == object.scale && shear == object.shear && bounds == box;
}

void PlacementStore::makeRoom(std::size_t objects) {
    if (entries_.size() < objects) {
        entries_.resize(objects);
    }
}

const Placement& PlacementStore::of(std::size_t index, const Object& object, const Bounds& bounds) {
    Entry& entry = entries_[index];
    if (!entry.isOf(object, bounds)) {
        entry.translation = object.translation;
        entry.rotation = object.rotation;
        entry.scale = object.scale;
        entry.shear = object.shear;
        entry.bounds = bounds;
        entry.isKnown = true;
        entry.placement = placementOf(object, bounds);
    }
    return entry.placement;
}

} // namespace patina
