// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/mesh.h"
#include "scene/scene.h"

namespace patina {

/// Measures how deep what is drawn reaches, seen from the camera.
class DepthRange {
  public:
    /// Adds a box of object space.
    void add(const Bounds& bounds, const glm::dmat4& objectToCamera);

    /// Adds points of world space.
    void add(std::span<const glm::dvec3> points, const glm::dmat4& worldToCamera);

    /// Adds a distance along the view.
    void add(double depth);

    /// Adds a distance from the eye.
    void addReach(double distance);

    /// Returns distances of the near and the far plane: around everything that was added, the near
    /// one at least a ten-thousandth of the far one so that depths stay apart. 0.1 and 100 for
    /// nothing.
    double near() const;
    double far() const;

    /// Returns the distance from the eye to the farthest point; 0 for nothing.
    double farthest() const { return farthestPoint_; }

  private:
    double farthestPoint_ = 0.0;
    double nearest_ = 1e30;
    double farthest_ = 0.0;
};

/// Returns the perspective of a camera whose image is `aspect` times as wide as high. The
/// (vertical) field of view is brought into 1 .. 170 degrees. What the camera's own planes cut away
/// is not in it; without them all depths are.
glm::dmat4 projection(const Camera& camera, double aspect, const DepthRange& depths);

} // namespace patina
