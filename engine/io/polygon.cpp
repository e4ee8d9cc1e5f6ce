// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polygon.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace patina {
namespace {

glm::dvec3 normalOf(const std::vector<glm::dvec3>& points) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        sum += glm::cross(points[i] - points[0], points[i + 1] - points[0]);
    }
    const double length = glm::length(sum);
    return length > 0.0 && std::isfinite(length) ? sum / length : glm::dvec3(0.0);
}

double squareOf(const glm::dvec3& side) {
    return glm::dot(side, side);
}

} // namespace

void Polygon::assign(std::span<const glm::vec3> positions,
                     std::span<const std::uint32_t> corners) {
    points_.clear();
    for (const std::uint32_t corner : corners) {
        points_.emplace_back(positions[corner]);
    }
    normal_ = normalOf(points_);
}

double Polygon::shape(std::size_t i, std::size_t j, std::size_t k) const {
    const glm::dvec3 first = points_[j] - points_[i];
    const glm::dvec3 second = points_[k] - points_[i];
    const double longest =
        std::max({squareOf(first), squareOf(second), squareOf(second - first)});
    return longest > 0.0 ? glm::dot(glm::cross(first, second), normal_) / longest : 0.0;
}

} // namespace patina
