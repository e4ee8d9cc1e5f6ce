// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "core/value.h"

namespace patina {

/// Is a curve's points. The curve is a monotone cubic through points from x = 0 to 1 (F. N. Fritsch
/// and R. E. Carlson, Monotone Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17, 1980, with
/// the slopes of F. N. Fritsch and J. Butland, 1984): between two points it stays between their
/// values. Before the first and after the last it is constant.
using CurvePoints = std::vector<glm::dvec2>;

inline constexpr std::size_t minCurvePoints = 2;
inline constexpr std::size_t maxCurvePoints = 16;

/// Is the smallest distance between the x of two points: a steeper edge would be a jump, on which
/// rounding decides.
inline constexpr double minCurveGap = 0.001;

/// Returns the points of a value; empty where it is no curve.
CurvePoints curvePoints(const Value& value);

Value curveValue(std::span<const glm::dvec2> points);

/// Tells whether the curve is y = x for every x from 0 to 1.
bool isLinear(std::span<const glm::dvec2> points);

/// Evaluates the curve through points as the shader does.
class CurveShape {
  public:
    /// Takes at most maxCurvePoints, with x rising by minCurveGap or more.
    explicit CurveShape(std::span<const glm::dvec2> points);

    double at(double x) const;

  private:
    std::vector<double> numbers_;
};

/// Is a ready-made curve that users may start with.
struct CurvePreset {
    std::string_view id;
    std::string_view label;
    CurvePoints points;
};
std::span<const CurvePreset> curvePresets();

} // namespace patina
