// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace patina {

/// Holds the corners of a polygon, seen from the side where its outline runs counter-clockwise.
class Polygon {
  public:
    /// Replaces the corners; `positions` are those of the whole mesh.
    void assign(std::span<const glm::vec3> positions, std::span<const std::uint32_t> corners);

    std::size_t size() const { return points_.size(); }
    const glm::dvec3& point(std::size_t i) const { return points_[i]; }

    /// Appends a point that is no corner of the outline. The normal stays as it is.
    void add(const glm::dvec3& point) { points_.push_back(point); }

    /// Returns the mean direction of the surface (M. E. Newell), of length 1. It is zero for a
    /// polygon without an area, and where a corner has no finite position.
    const glm::dvec3& normal() const { return normal_; }

    /// Returns twice the area of a triangle seen along the normal, divided by the square of its
    /// longest side: at most sqrt(3) / 2, 0 when the corners lie on one line, negative where it is
    /// seen from behind.
    double shape(std::size_t i, std::size_t j, std::size_t k) const;

  private:
    std::vector<glm::dvec3> points_;
    glm::dvec3 normal_{0.0};
};

/// Is the shape below which a triangle counts as a line: its own normal would be rounding noise.
inline constexpr double thinnestShape = 1e-5;

} // namespace patina
