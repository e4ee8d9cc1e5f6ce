// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "core/mesh.h"
#include "render/gpu/instance.h"
#include "render/lights/light_lists.h"
#include "scene/scene.h"

namespace patina {

/// Holds where an object is, in world space, computed from its transform and its mesh's box.
struct Placement {
    glm::dmat4 world{1.0};
    glm::dvec3 middle{0.0};              ///< is the middle of the bounding box, in world space
    std::array<glm::dvec3, 8> corners{}; ///< are those of the bounding box, in world space
    Ball ball;                           ///< is the bounding sphere of the box
    Instance instance;
};

Placement placementOf(const Object& object, const Bounds& bounds);

/// Returns the corners of a box around all that is no farther than `metres` from the box.
std::array<glm::dvec3, 8> cornersWithin(const Placement& placement, double metres);

/// Returns true when nothing within `metres` of the box can be in the picture. `worldToClip` is a
/// perspective; its near and far plane do not matter.
bool isOutside(const Placement& placement, const glm::dmat4& worldToClip, double metres = 0.0);

/// Keeps the placements of a scene's objects and computes one again only when it has changed.
class PlacementStore {
  public:
    /// Makes room for this many objects, so that references to placements stay valid during the
    /// frame.
    void makeRoom(std::size_t objects);
    const Placement& of(std::size_t index, const Object& object, const Bounds& bounds);

  private:
    struct Entry {
        glm::dvec3 translation{0.0};
        glm::dvec3 rotation{0.0};
        glm::dvec3 scale{0.0};
        glm::dvec3 shear{0.0};
        Bounds bounds;
        bool isKnown = false;
        Placement placement;

        bool isOf(const Object& object, const Bounds& box) const;
    };

    std::vector<Entry> entries_;
};

} // namespace patina
