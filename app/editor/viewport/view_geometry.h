// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <QPointF>

#include "viewport/ray_cast.h"

namespace patina {

/// Knows how the world lies in a view: its camera and its size in pixels.
struct ViewGeometry {
    Camera camera;
    glm::dvec2 size{1.0};

    Ray ray(QPointF place) const;
    /// Nothing: the point does not lie before the eye.
    std::optional<QPointF> place(const glm::dvec3& point) const;
    double metresPerPixel(const glm::dvec3& at) const;
    /// The point under a place that is as deep as another point.
    glm::dvec3 pointBeside(QPointF place, const glm::dvec3& depth) const;
    /// How far from `origin` along a unit vector the line comes nearest to what is under a place.
    /// The start where the line runs along the sight.
    double alongAxis(QPointF place, const glm::dvec3& origin, const glm::dvec3& axis) const;
    /// The points in the view; those behind the eye are left out.
    std::vector<QPointF> places(std::span<const glm::dvec3> points) const;
};

/// The points of a circle about a unit vector.
std::vector<glm::dvec3> circle(const glm::dvec3& middle, const glm::dvec3& axis, double radius);

/// Distance in pixels to a line of points; infinity without one.
double distanceToLine(QPointF place, std::span<const QPointF> line);

} // namespace patina
