// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

/// Holds the widths of a highlight across a grain, where it is long, and along it.
struct GrainWidths {
    double across = 1.0;
    double along = 1.0;
};

/// Holds the same as MeshMaterial says it.
struct GrainShape {
    double alpha = 1.0;      ///< is the geometric mean of both widths
    double anisotropy = 0.0; ///< is (1 - along / across) / 0.9
};

/// Returns the widths by B. Burley, Physically-Based Shading at Disney, SIGGRAPH 2012 course.
GrainWidths widthsOf(const GrainShape& shape);

/// Returns the shape of two widths above 0. Its anisotropy is above 1 where the widths differ by
/// more than ten times.
GrainShape shapeOf(const GrainWidths& widths);

/// Returns the grain's direction in degrees, 0 to below 180, where a highlight is long in the
/// direction of `angle`, in radians from the tangent.
double grainAcross(double angle);

/// Returns the direction in radians, -pi/2 to pi/2, in which the highlight of a grain at `degrees`
/// is long.
double streakAcross(double degrees);

} // namespace patina
