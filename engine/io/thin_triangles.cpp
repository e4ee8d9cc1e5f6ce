// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/thin_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace patina {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// Returns the triangle with the corner opposite its longest side first.
Triangle fromItsTip(const Polygon& polygon, const Triangle& t) {
    const auto across = [&](std::size_t i) {
        return glm::distance(polygon.point(t[(i + 1) % 3]), polygon.point(t[(i + 2) % 3]));
    };
    const std::size_t tip = across(0) >= across(1) ? (across(0) >= across(2) ? 0 : 2)
                                                   : (across(1) >= across(2) ? 1 : 2);
    return {t[tip], t[(tip + 1) % 3], t[(tip + 2) % 3]};
}

bool isThin(const Polygon& polygon, const Triangle& t) {
    return polygon.shape(t[0], t[1], t[2]) < thinnestShape;
}

bool hasThin(const Polygon& polygon, const std::vector<std::uint32_t>& triangles) {
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
        if (isThin(polygon, {triangles[i], triangles[i + 1], triangles[i + 2]})) {
            return true;
        }
    }
    return false;
}

/// Finds each triangle by its edges, in the direction in which it runs along them.
class Turner {
  public:
    Turner(const Polygon& polygon, std::vector<std::uint32_t>& triangles)
        : polygon_(polygon), triangles_(triangles) {
        for (std::size_t i = 0; i + 2 < triangles_.size(); i += 3) {
            put(i, at(i));
        }
    }

    /// Turns every thin triangle that can be. Returns whether any was, which may give the next one
    /// a neighbour.
    bool turnOnce() {
        bool turned = false;
        for (std::size_t i = 0; i + 2 < triangles_.size(); i += 3) {
            if (isThin(polygon_, at(i))) {
                turned |= turn(i);
            }
        }
        return turned;
    }

  private:
    static std::uint64_t edge(std::uint32_t from, std::uint32_t to) {
        return (std::uint64_t(from) << 32) | to;
    }

    Triangle at(std::size_t i) const {
        return {triangles_[i], triangles_[i + 1], triangles_[i + 2]};
    }

    void put(std::size_t i, const Triangle& triangle) {
        for (std::size_t k = 0; k < 3; ++k) {
            triangles_[i + k] = triangle[k];
            edges_[edge(triangle[k], triangle[(k + 1) % 3])] = i;
        }
    }

    bool turn(std::size_t i) {
        const Triangle thin = fromItsTip(polygon_, at(i));
        const auto beside = edges_.find(edge(thin[2], thin[1]));
        if (beside == edges_.end()) {
            return false;
        }
        const std::size_t other = beside->second;
        const Triangle neighbour = at(other);
        const auto apex = std::ranges::find_if(neighbour, [&thin](std::uint32_t corner) {
            return corner != thin[1] && corner != thin[2];
        });
        if (apex == neighbour.end()) {
            return false;
        }
        const Triangle first{thin[0], thin[1], *apex};
        const Triangle second{thin[0], *apex, thin[2]};
        if (shapeOf(first) <= std::max(shapeOf(thin), 0.0) || shapeOf(second) <= 0.0) {
            return false;
        }
        edges_.erase(edge(thin[1], thin[2]));
        edges_.erase(edge(thin[2], thin[1]));
        put(i, first);
        put(other, second);
        return true;
    }

    double shapeOf(const Triangle& t) const { return polygon_.shape(t[0], t[1], t[2]); }

    const Polygon& polygon_;
    std::vector<std::uint32_t>& triangles_;
    /// Maps an edge to the first index of its triangle.
    std::unordered_map<std::uint64_t, std::size_t> edges_;
};

} // namespace

void turnThinTriangles(const Polygon& polygon, std::vector<std::uint32_t>& triangles) {
    constexpr int maxRounds = 16;
    if (!hasThin(polygon, triangles)) {
        return;
    }
    Turner turner(polygon, triangles);
    for (int round = 0; round < maxRounds && turner.turnOnce(); ++round) {
    }
}

} // namespace patina
