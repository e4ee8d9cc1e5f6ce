// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polygon_cutter.h"

#include <algorithm>

#include "io/polygon_tessellator.h"

namespace patina {
namespace {

/// Tells whether a quad is better cut from corner 1 to 3 than from corner 0 to 2.
bool isBetterAlongSecond(const Polygon& quad) {
    const double first = std::min(quad.shape(0, 1, 2), quad.shape(0, 2, 3));
    return first <= thinnestShape &&
           std::min(quad.shape(1, 2, 3), quad.shape(1, 3, 0)) > first;
}

/// Tells whether all corners can be seen from the first one, within half a turn, and no triangle of
/// the fan is thin.
bool isFan(const Polygon& polygon) {
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        if (polygon.shape(0, i, i + 1) <= thinnestShape || polygon.shape(0, 1, i + 1) < 0.0) {
            return false;
        }
    }
    return true;
}

/// Appends the blend of an attribute if each of the vertices so far has a value of it.
template <class Vector>
void appendBlend(std::vector<Vector>& all, std::size_t vertices, const CrossingPoint& crossing,
                 std::span<const std::uint32_t> numbers) {
    if (all.size() != vertices) {
        return;
    }
    Vector blend(0.0f);
    for (std::size_t i = 0; i < crossing.points.size(); ++i) {
        blend += crossing.shares[i] * all[numbers[crossing.points[i]]];
    }
    all.push_back(blend);
}

} // namespace

void PolygonCutter::cut(std::span<const std::uint32_t> corners) {
    if (corners.size() == 3) {
        mesh_.indices.insert(mesh_.indices.end(), corners.begin(), corners.end());
        return;
    }
    polygon_.assign(mesh_.positions, corners);
    if (corners.size() == 4) {
        cutQuad(corners);
    } else if (isFan(polygon_) || !cutAnyhow(corners)) {
        cutFan(corners);
    }
}

void PolygonCutter::cutQuad(std::span<const std::uint32_t> corners) {
    const std::size_t first = isBetterAlongSecond(polygon_) ? 1 : 0;
    const auto corner = [&](std::size_t i) { return corners[(first + i) % 4]; };
    mesh_.indices.insert(mesh_.indices.end(), {corner(0), corner(1), corner(2), corner(0),
                                               corner(2), corner(3)});
}

void PolygonCutter::cutFan(std::span<const std::uint32_t> corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        mesh_.indices.insert(mesh_.indices.end(), {corners[0], corners[i], corners[i + 1]});
    }
}

bool PolygonCutter::cutAnyhow(std::span<const std::uint32_t> corners) {
    const auto made = tessellate(polygon_);
    if (!made) {
        return false;
    }
    std::vector<std::uint32_t> vertices(corners.begin(), corners.end());
    for (const CrossingPoint& crossing : made->crossings) {
        vertices.push_back(addVertex(crossing, vertices, polygon_.point(vertices.size())));
    }
    for (const std::uint32_t point : made->triangles) {
        mesh_.indices.push_back(vertices[point]);
    }
    return true;
}

std::uint32_t PolygonCutter::addVertex(const CrossingPoint& crossing,
                                       std::span<const std::uint32_t> vertices,
                                       const glm::dvec3& place) {
    const std::size_t count = mesh_.positions.size();
    appendBlend(mesh_.normals, count, crossing, vertices);
    appendBlend(mesh_.uvs, count, crossing, vertices);
    appendBlend(mesh_.colors, count, crossing, vertices);
    appendBlend(mesh_.tangents, count, crossing, vertices);
    mesh_.positions.emplace_back(place);
    return static_cast<std::uint32_t>(count);
}

} // namespace patina
