// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace patina {
namespace {

constexpr double shortestDistance = 1e-3;
constexpr double longestDistance = 1e5;

/// Leaves a margin around a framed object, which then takes up 88 % of the view.
constexpr double frameMargin = 1.0 / 0.88;

double halfAngle(const Camera& camera) {
    return 0.5 * glm::radians(camera.fieldOfView);
}

/// Returns an axis of the camera in world space: row 0 of the view matrix points to the right, row
/// 1 up.
glm::dvec3 axis(const Camera& camera, int row) {
    const glm::dmat4 view = viewMatrix(camera);
    return {view[0][row], view[1][row], view[2][row]};
}

/// Finds the eye that sees all added points within an opening along one axis of the view, from as
/// near as it can: |x - eye.x| <= tangent (eye.z - z) for each, in coordinates of the camera.
class Fitting {
  public:
    explicit Fitting(double tangent) : tangent_(tangent) {}

    void add(double x, double z) {
        upper_ = std::max(upper_, x + tangent_ * z);
        lower_ = std::min(lower_, x - tangent_ * z);
    }
    double sideways() const { return 0.5 * (upper_ + lower_); }
    double distance() const { return 0.5 * (upper_ - lower_) / tangent_; }

  private:
    double tangent_;
    double upper_ = -std::numeric_limits<double>::infinity();
    double lower_ = std::numeric_limits<double>::infinity();
};

bool hasExtent(const MeshView& mesh) {
    return !mesh.bounds.empty() && !mesh.vertices.empty();
}

glm::dvec3 middleOf(const PlacedMesh& placed) {
    return worldMatrix(placed.object) * glm::dvec4(placed.mesh.bounds.center(), 1.0);
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

Camera zoomedTo(const Camera& camera, double factor, const glm::dvec2& place,
                const glm::dvec2& size) {
    const glm::dvec2 pixels =
        place - 0.5 * size; // pans the place to the middle, and back after the dolly
    const Camera there = dollied(panned(camera, -pixels, size.y), factor);
    return panned(there, pixels, size.y);
}

Camera withLens(const Camera& camera, double fieldOfView) {
    Camera moved = camera;
    moved.fieldOfView = fieldOfView;
    moved.distance = camera.distance * std::tan(halfAngle(camera)) / std::tan(halfAngle(moved));
    return dollied(moved, 1.0);
}

Camera framed(const Camera& camera, std::span<const PlacedMesh> objects, double aspect) {
    glm::dvec3 sum(0.0);
    int counted = 0;
    for (const PlacedMesh& placed : objects) {
        if (hasExtent(placed.mesh)) {
            sum += middleOf(placed);
            ++counted;
        }
    }
    if (counted == 0) {
        return camera;
    }
    const glm::dvec3 middle = sum / double(counted);
    const double tangent = std::tan(halfAngle(camera)) / frameMargin;
    Fitting across(tangent * aspect);
    Fitting along(tangent);
    const glm::dmat3 axes(axis(camera, 0), axis(camera, 1), axis(camera, 2));
    for (const PlacedMesh& placed : objects) {
        const glm::dmat4 world = worldMatrix(placed.object);
        for (const Vertex& vertex : placed.mesh.vertices) {
            const glm::dvec3 place(world * glm::dvec4(vertex.position, 1.0));
            const glm::dvec3 seen = (place - middle) * axes;
            across.add(seen.x, seen.z);
            along.add(seen.y, seen.z);
        }
    }
    Camera moved = camera;
    moved.pivot = middle + axes[0] * across.sideways() + axes[1] * along.sideways();
    moved.distance = 1.0;
    return dollied(moved, std::max(across.distance(), along.distance()));
}

Camera framed(const Camera& camera, const Object& object, const MeshView& mesh, double aspect) {
    const PlacedMesh placed{object, mesh};
    return framed(camera, {&placed, 1}, aspect);
}

bool isSameView(const Camera& a, const Camera& b) {
    constexpr double rounding = 1e-6; // of a distance; far less than a pixel
    return glm::distance(a.pivot, b.pivot) <= rounding * b.distance &&
           std::abs(a.distance - b.distance) <= rounding * b.distance && a.yaw == b.yaw &&
           a.pitch == b.pitch && a.fieldOfView == b.fieldOfView && a.nearPlane == b.nearPlane &&
           a.farPlane == b.farPlane;
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
