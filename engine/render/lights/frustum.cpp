// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/frustum.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace patina {
namespace {

constexpr double minDepthShare = 0.99; ///< limits the near plane to this share of the far one
constexpr double minThickness = 1e-4;  ///< is the least distance between the planes, as a share of
                                       ///< the near one

} // namespace

void DepthRange::add(const Bounds& bounds, const glm::dmat4& objectToCamera) {
    if (bounds.empty()) {
        return;
    }
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 point((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                               (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y,
                               (corner & 4) != 0 ? bounds.upper.z : bounds.lower.z, 1.0);
        const glm::dvec3 seen(objectToCamera * point);
        add(-seen.z);
        addReach(glm::length(seen));
    }
}

void DepthRange::add(std::span<const glm::dvec3> points, const glm::dmat4& worldToCamera) {
    for (const glm::dvec3& point : points) {
        const glm::dvec3 seen(worldToCamera * glm::dvec4(point, 1.0));
        add(-seen.z);
        addReach(glm::length(seen));
    }
}

void DepthRange::addReach(double distance) {
    if (std::isfinite(distance)) {
        farthestPoint_ = std::max(farthestPoint_, distance);
    }
}

void DepthRange::add(double depth) {
    if (std::isfinite(depth)) {
        nearest_ = std::min(nearest_, depth);
        farthest_ = std::max(farthest_, depth);
    }
}

double DepthRange::far() const {
    return farthest_ > 0.0 ? 1.01 * farthest_ : 100.0;
}

double DepthRange::near() const {
    return farthest_ > 0.0 ? std::max(0.99 * nearest_, 1e-4 * far()) : 0.1;
}

glm::dmat4 projection(const Camera& camera, double aspect, const DepthRange& depths) {
    const double angle = glm::radians(std::clamp(camera.fieldOfView, 1.0, 170.0));
    const double far = camera.farPlane > 0.0 ? camera.farPlane : depths.far();
    const double near =
        camera.nearPlane > 0.0 ? camera.nearPlane : std::min(depths.near(), minDepthShare * far);
    return glm::perspective(angle, aspect, near, std::max(far, near * (1.0 + minThickness)));
}

} // namespace patina
