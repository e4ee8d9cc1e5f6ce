// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "core/error.h"
#include "measure/eval/eval_case.h"
#include "measured/measured_reflectance.h"

namespace patina {

/// Holds the reflectance to be matched: pi f cos(theta_l), as models return it, at many pairs of
/// directions.
struct MatchTarget {
    std::vector<DirectionPair> pairs;
    std::vector<glm::dvec3> values;
    bool isIsotropic = true;

    /// Returns `count` of them, evenly taken; all where there are fewer.
    MatchTarget thinned(std::size_t count) const;
};

/// Returns a target of what was measured, without directions more than 80 degrees from the normal,
/// where instruments see little.
MatchTarget matchTarget(const MeasuredReflectance& measured, std::size_t samples);

/// Returns a target of a material's model (sweepVariant()), in directions that are dense around the
/// mirror direction and sparse at grazing angles. It is an error where the model has no code in
/// double precision.
Result<MatchTarget> matchTarget(const EvalCase& model, std::size_t samples);

} // namespace patina
