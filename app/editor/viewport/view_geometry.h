// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <QPointF>

#include "viewport/ray_cast.h"

namespace patina {

/// Projects between the world and a view: it holds the camera and the size of the view in pixels.
struct ViewGeometry {
    Camera camera;
    glm::dvec2 size{1.0};

    Ray ray(QPointF place) const;
    /// Returns where a point is seen; nothing where it does not lie before the eye.
    std::optional<QPointF> place(const glm::dvec3& point) const;
    double metresPerPixel(const glm::dvec3& at) const;
    /// Returns the point under a place that is as deep as another point.
    glm::dvec3 pointBeside(QPointF place, const glm::dvec3& depth) const;
    /// Returns how far from `origin` along a unit vector, in metres, the axis comes nearest to the
    /// sight line under a place; 0 where both are parallel.
    double alongAxis(QPointF place, const glm::dvec3& origin, const glm::dvec3& axis) const;
    /// Returns where points are seen; those behind the eye are left out.
    std::vector<QPointF> places(std::span<const glm::dvec3> points) const;
};

/// Returns points of a circle about a unit vector, closed: the first one is also the last.
std::vector<glm::dvec3> circle(const glm::dvec3& middle, const glm::dvec3& axis, double radius);

/// Returns the distance in pixels to a line of points; infinity where there are fewer than two.
double distanceToLine(QPointF place, std::span<const QPointF> line);

} // namespace patina
