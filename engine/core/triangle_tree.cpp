// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/vectors.h"

namespace patina {
namespace {

constexpr std::uint32_t leafTriangles = 4;

/// Enlarges triangles by this part of their sides, so that no ray slips through between two.
constexpr float overlap = 1e-5f;

/// Limits the tree's depth: each level halves the triangles, and there are fewer than 2^32.
constexpr std::size_t maxDepth = 40;

/// Returns one over the direction, so that it is finite where the ray runs along a side of a box.
glm::vec3 inverseOf(const glm::vec3& direction) {
    glm::vec3 inverse;
    for (int i = 0; i < 3; ++i) {
        inverse[i] = 1.0f / (std::abs(direction[i]) > 1e-12f ? direction[i] : 1e-12f);
    }
    return inverse;
}

/// Tells whether the ray passes through the box (Kay and Kajiya 1986).
bool meetsBox(const glm::vec3& lower, const glm::vec3& upper, const glm::vec3& origin,
              const glm::vec3& inverse) {
    float enter = 0.0f;
    float leave = INFINITY;
    for (int i = 0; i < 3; ++i) {
        const float a = (lower[i] - origin[i]) * inverse[i];
        const float b = (upper[i] - origin[i]) * inverse[i];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave * 1.000001f;
}

} // namespace

TriangleTree::TriangleTree(std::span<const glm::vec3> corners) {
    triangles_.reserve(corners.size() / 3);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const Triangle triangle{corners[i], corners[i + 1] - corners[i],
                                corners[i + 2] - corners[i]};
        const glm::vec3 area = glm::cross(triangle.first, triangle.second);
        if (isFinite(triangle.corner) && isFinite(area) && glm::dot(area, area) > 0.0f) {
            triangles_.push_back(triangle);
        }
    }
    if (triangles_.empty()) {
        return;
    }
    std::vector<std::uint32_t> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0u);
    nodes_.reserve(order.size());
    build(order, 0, static_cast<std::uint32_t>(order.size()));
    std::vector<Triangle> sorted;
    sorted.reserve(order.size());
    for (const std::uint32_t index : order) {
        sorted.push_back(triangles_[index]);
    }
    triangles_ = std::move(sorted);
}

/// Splits the triangles at the median of their centroids, along the longest side of the box around
/// those.
void TriangleTree::build(std::vector<std::uint32_t>& order, std::uint32_t first,
                         std::uint32_t last) {
    const auto middle = [this](std::uint32_t index) {
        const Triangle& triangle = triangles_[index];
        return triangle.corner + (triangle.first + triangle.second) * (1.0f / 3.0f);
    };
    Node node{glm::vec3(INFINITY), first, glm::vec3(-INFINITY), 0};
    glm::vec3 lower(INFINITY);
    glm::vec3 upper(-INFINITY);
    for (std::uint32_t i = first; i < last; ++i) {
        const Triangle& triangle = triangles_[order[i]];
        for (const glm::vec3& corner : {triangle.corner, triangle.corner + triangle.first,
                                        triangle.corner + triangle.second}) {
            node.lower = glm::min(node.lower, corner);
            node.upper = glm::max(node.upper, corner);
        }
        lower = glm::min(lower, middle(order[i]));
        upper = glm::max(upper, middle(order[i]));
    }
    const std::size_t at = nodes_.size();
    if (last - first <= leafTriangles) {
        node.count = last - first;
        nodes_.push_back(node);
        return;
    }
    nodes_.push_back(node);
    const glm::vec3 size = upper - lower;
    const int across = size.y > size.z ? 1 : 2;
    const int axis = size.x > size[across] ? 0 : across;
    nodes_[at].axis = axis;
    const std::uint32_t split = first + (last - first) / 2;
    std::nth_element(
        order.begin() + first, order.begin() + split, order.begin() + last,
        [&](std::uint32_t a, std::uint32_t b) { return middle(a)[axis] < middle(b)[axis]; });
    build(order, first, split);
    nodes_[at].other = static_cast<std::uint32_t>(nodes_.size());
    build(order, split, last);
}

/// Intersects triangles by the method of Möller and Trumbore (1997).
bool TriangleTree::isHit(const glm::vec3& origin, const glm::vec3& direction) const {
    const auto isMet = [&](const Triangle& triangle) {
        const glm::vec3 across = glm::cross(direction, triangle.second);
        const float determinant = glm::dot(triangle.first, across);
        if (determinant == 0.0f) {
            return false;
        }
        const float scale = 1.0f / determinant;
        const glm::vec3 from = origin - triangle.corner;
        const float u = glm::dot(from, across) * scale;
        const glm::vec3 beside = glm::cross(from, triangle.first);
        const float v = glm::dot(direction, beside) * scale;
        return u >= -overlap && v >= -overlap && u + v <= 1.0f + overlap &&
               glm::dot(triangle.second, beside) * scale > 0.0f;
    };
    const glm::vec3 inverse = inverseOf(direction);
    std::array<std::uint32_t, maxDepth> waiting{};
    std::size_t count = nodes_.empty() ? 0 : 1;
    while (count > 0) {
        const std::uint32_t at = waiting[--count];
        const Node& node = nodes_[at];
        if (!meetsBox(node.lower, node.upper, origin, inverse)) {
            continue;
        }
        if (node.count == 0) {
            const bool isAlong = direction[node.axis] > 0.0f; // the nearer child comes first
            waiting[count++] = isAlong ? node.other : at + 1;
            waiting[count++] = isAlong ? at + 1 : node.other;
            continue;
        }
        const auto leaf = std::span(triangles_).subspan(node.other, node.count);
        if (std::ranges::any_of(leaf, isMet)) {
            return true;
        }
    }
    return false;
}

} // namespace patina
