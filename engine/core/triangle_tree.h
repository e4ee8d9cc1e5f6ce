// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// A tree of boxes around triangles (a bounding volume hierarchy), for asking whether a ray meets
/// any of them. Asked by several threads at once.
class TriangleTree {
  public:
    /// Corners, three per triangle; triangles without an area and those with a corner that is no
    /// number are left out.
    explicit TriangleTree(std::span<const glm::vec3> corners);

    /// Tells whether the ray meets a triangle, from whatever side. `direction` is unit.
    bool isHit(const glm::vec3& origin, const glm::vec3& direction) const;

  private:
    struct Triangle {
        glm::vec3 corner;
        glm::vec3 first; ///< edges from the corner
        glm::vec3 second;
    };
    /// Children stand behind one another: the first right behind its parent.
    struct Node {
        glm::vec3 lower;
        std::uint32_t other = 0; ///< the second child, or the first triangle of a leaf
        glm::vec3 upper;
        std::uint32_t count = 0; ///< triangles of a leaf; 0: it has children
        int axis = 0;            ///< along which they lie
    };

    void build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last);

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

} // namespace patina
