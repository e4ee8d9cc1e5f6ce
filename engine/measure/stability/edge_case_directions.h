// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "measure/eval/eval_case.h"

namespace patina {

/// Is how far from the origin along each axis, in metres, common places are that are points.
inline constexpr double ordinaryReach = 5.0;

/// Returns the places where formulas break, all exact in float. Models get light and viewer at
/// cosines of 0, the smallest float, 1e-30, 6e-17, 1e-12, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.3, 0.5,
/// 0.7, 0.9, 1 - 1e-4, 1 - 1e-6, 1 - 1e-8 and 1, above the horizon and below, in every azimuth
/// relation (equal, opposite, mirrored, slightly off these), about upright and slanting normals and
/// with tangents along the normal. The other kinds get those cosines, points and distances from 0
/// to a million and beyond.
std::vector<EvalPlace> edgeCaseDirections(EvalCase::Subject subject);

/// Returns `count` places that are common in scenes: cosines of at least 0.05, and one viewer in
/// three near the mirror direction. They are the same for every call.
std::vector<EvalPlace> ordinaryPlaces(EvalCase::Subject subject, std::size_t count);

} // namespace patina
