// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// The corners of a polygon, as they look from the side its outline runs around to the left.
class Polygon {
  public:
    /// Takes the corners anew; `positions` are those of the whole mesh.
    void assign(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners);

    std::size_t size() const { return points_.size(); }
    const glm::dvec3& point(std::size_t i) const { return points_[i]; }

    /// A point that is no corner; it follows the others.
    void add(const glm::dvec3& point) { points_.push_back(point); }

    /// The mean direction of the surface (M. E. Newell), of length 1. Zero for a polygon without an
    /// area, and where a corner has no finite position.
    const glm::dvec3& normal() const { return normal_; }

    /// Twice the area of a triangle seen along the normal, in squares of its longest side: at most
    /// sqrt(3) / 2, 0 on one line, negative where it is seen from behind.
    double shape(std::size_t i, std::size_t j, std::size_t k) const;

  private:
    std::vector<glm::dvec3> points_;
    glm::dvec3 normal_{0.0};
};

/// Triangles of a smaller shape than this are as good as lines; their own normal is rounding.
inline constexpr double thinnestShape = 1e-5;

} // namespace patina
