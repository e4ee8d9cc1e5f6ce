// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_moves.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace patina {
namespace {

constexpr double shortestDistance = 1e-3;
constexpr double longestDistance = 1e5;

/// Air around a framed object, as a share of its size.
constexpr double frameMargin = 1.08;

double halfAngle(const Camera& camera) {
    return 0.5 * glm::radians(camera.fieldOfView);
}

/// The matrix's rows are the camera's axes in world space.
glm::dvec3 axis(const Camera& camera, int row) {
    const glm::dmat4 view = viewMatrix(camera);
    return {view[0][row], view[1][row], view[2][row]};
}

/// How far from the pivot the eye must be to have a place beside the pivot inside the view.
double distanceToShow(const Camera& camera, const glm::dvec3& place, double aspect) {
    const double tangent = std::tan(halfAngle(camera)) / frameMargin;
    const double across = std::abs(glm::dot(place, axis(camera, 0))) / (tangent * aspect);
    const double along = std::abs(glm::dot(place, axis(camera, 1))) / tangent;
    return glm::dot(place, axis(camera, 2)) + std::max(across, along);
}

} // namespace

Camera orbited(const Camera& camera, double yaw, double pitch) {
    Camera moved = camera;
    moved.yaw = std::remainder(camera.yaw + yaw, 360.0);
    moved.pitch = std::clamp(camera.pitch + pitch, -90.0, 90.0);
    return moved;
}

Camera panned(const Camera& camera, const glm::dvec2& pixels, double height) {
    const double metresPerPixel = 2.0 * camera.distance * std::tan(halfAngle(camera)) / height;
    Camera moved = camera;
    moved.pivot -= rightOf(camera) * (pixels.x * metresPerPixel);
    moved.pivot += upOf(camera) * (pixels.y * metresPerPixel);
    return moved;
}

Camera dollied(const Camera& camera, double factor) {
    Camera moved = camera;
    moved.distance = std::clamp(camera.distance * factor, shortestDistance, longestDistance);
    return moved;
}

Camera framed(const Camera& camera, const Bounds& box, double aspect) {
    if (box.empty()) {
        return camera;
    }
    double distance = shortestDistance;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 sign{(corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                              (corner & 4) != 0 ? 0.5 : -0.5};
        distance =
            std::max(distance, distanceToShow(camera, sign * glm::dvec3(box.size()), aspect));
    }
    Camera moved = camera;
    moved.pivot = glm::dvec3(box.center());
    moved.distance = 1.0;
    return dollied(moved, distance);
}

Camera pivotedAt(const Camera& camera, const glm::dvec3& pivot) {
    const glm::dvec3 outward = eye(camera) - pivot;
    const double distance = glm::length(outward);
    if (!(distance > shortestDistance)) {
        return camera;
    }
    Camera moved = camera;
    moved.pivot = pivot;
    moved.distance = std::min(distance, longestDistance);
    moved.yaw = glm::degrees(std::atan2(outward.x, outward.z));
    moved.pitch = glm::degrees(std::asin(std::clamp(outward.y / distance, -1.0, 1.0)));
    return moved;
}

glm::dvec3 rightOf(const Camera& camera) {
    return axis(camera, 0);
}

glm::dvec3 upOf(const Camera& camera) {
    return axis(camera, 1);
}

} // namespace patina
