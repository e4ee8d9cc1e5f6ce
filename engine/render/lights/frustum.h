// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/mesh.h"
#include "scene/scene.h"

namespace patina {

/// Collects the depths of what is drawn, in metres from the camera.
class DepthRange {
  public:
    /// Adds a box of object space.
    void add(const Bounds& bounds, const glm::dmat4& objectToCamera);

    /// Adds points of world space.
    void add(std::span<const glm::dvec3> points, const glm::dmat4& worldToCamera);

    /// Adds a depth, the distance along the direction of view; ignores one that is not finite.
    void add(double depth);

    /// Adds a distance from the eye; ignores one that is not finite.
    void addReach(double distance);

    /// Returns the distance of the near plane. Both planes enclose everything that was added; they
    /// are 0.1 and 100 without anything. The near one is at least a ten-thousandth of the far one,
    /// so that depths keep their precision.
    double near() const;
    double far() const;

    /// Returns the distance from the eye to the farthest point; 0 without any.
    double farthest() const { return farthestPoint_; }

  private:
    double farthestPoint_ = 0.0;
    double nearest_ = 1e30;
    double farthest_ = 0.0;
};

/// Returns the perspective of a camera whose image is `aspect` times as wide as high. The vertical
/// field of view is clamped to 1 .. 170 degrees. The planes are the camera's own where it has them,
/// else they enclose all depths.
glm::dmat4 projection(const Camera& camera, double aspect, const DepthRange& depths);

} // namespace patina
