// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// Is a tree of boxes around triangles (a bounding volume hierarchy), which tells whether a ray
/// hits any of them. Several threads may ask at once.
class TriangleTree {
  public:
    /// Takes the corners, three per triangle. Triangles without an area and those with a corner
    /// that is not finite are left out.
    explicit TriangleTree(std::span<const glm::vec3> corners);

    /// Tells whether the ray hits a triangle, from either side. `direction` is unit.
    bool isHit(const glm::vec3& origin, const glm::vec3& direction) const;

  private:
    struct Triangle {
        glm::vec3 corner;
        glm::vec3 first; ///< `first` and `second` are the edges from the corner
        glm::vec3 second;
    };
    /// Is a box with its children or, in a leaf, its triangles. The first child follows its parent
    /// directly.
    struct Node {
        glm::vec3 lower;
        /// Is the index of the second child, or of a leaf's first triangle.
        std::uint32_t other = 0;
        glm::vec3 upper;
        std::uint32_t count = 0; ///< counts the triangles of a leaf; 0: the node has children
        int axis = 0;            ///< is the axis along which the children lie
    };

    void build(std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last);

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;
};

} // namespace patina
