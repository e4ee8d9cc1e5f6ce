// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace patina {
namespace {

constexpr int circlePoints = 48;

double pixelsBetween(QPointF a, QPointF b) {
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

double distanceToPart(QPointF place, QPointF from, QPointF to) {
    const QPointF way = to - from;
    const double length = QPointF::dotProduct(way, way);
    const double share =
        length > 0.0 ? std::clamp(QPointF::dotProduct(place - from, way) / length, 0.0, 1.0) : 0.0;
    return pixelsBetween(place, from + share * way);
}

} // namespace

Ray ViewGeometry::ray(QPointF place) const {
    return rayThrough(camera, {place.x(), place.y()}, size);
}

std::optional<QPointF> ViewGeometry::place(const glm::dvec3& point) const {
    const auto seen = placeOf(camera, point, size);
    return seen ? std::optional(QPointF(seen->x, seen->y)) : std::nullopt;
}

double ViewGeometry::metresPerPixel(const glm::dvec3& at) const {
    return 1.0 / pixelsPerMetre(camera, at, size.y);
}

glm::dvec3 ViewGeometry::pointBeside(QPointF place, const glm::dvec3& depth) const {
    const Ray sight = ray(place);
    const glm::dvec3 forward = glm::normalize(camera.pivot - eye(camera));
    const double deep = glm::dot(depth - sight.origin, forward);
    return sight.origin + sight.direction * (deep / glm::dot(sight.direction, forward));
}

double ViewGeometry::alongAxis(QPointF place, const glm::dvec3& origin,
                               const glm::dvec3& axis) const {
    const Ray sight = ray(place);
    const double across = glm::dot(sight.direction, axis);
    const double apart = 1.0 - across * across; // the squared sine of the angle between both lines
    const glm::dvec3 between = origin - sight.origin;
    constexpr double minApart = 1e-4;
    return apart < minApart
               ? 0.0
               : (across * glm::dot(between, sight.direction) - glm::dot(between, axis)) / apart;
}

std::vector<QPointF> ViewGeometry::places(std::span<const glm::dvec3> points) const {
    std::vector<QPointF> seen;
    for (const glm::dvec3& point : points) {
        if (const auto at = place(point)) {
            seen.push_back(*at);
        }
    }
    return seen;
}

std::vector<glm::dvec3> circle(const glm::dvec3& middle, const glm::dvec3& axis, double radius) {
    const glm::dvec3 other = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(other, axis));
    const glm::dvec3 up = glm::cross(axis, right);
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= circlePoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / circlePoints;
        points.push_back(middle + radius * (std::cos(angle) * right + std::sin(angle) * up));
    }
    return points;
}

double distanceToLine(QPointF place, std::span<const QPointF> line) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i) {
        nearest = std::min(nearest, distanceToPart(place, line[i - 1], line[i]));
    }
    return nearest;
}

} // namespace patina
