// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/eval/reference_case.h"
#include "measure/stability/hemisphere_rule.h"

namespace patina::stability {

/// Light from `degrees` off the normal.
inline glm::dvec3 lightAt(double degrees) {
    const double theta = degrees * std::numbers::pi / 180.0;
    return {std::sin(theta), 0.0, std::cos(theta)};
}

/// The share of the light from there that comes back in all directions together, by the first
/// channel in double precision.
inline double albedo(const EvalCase& request, double degrees, const HemisphereRuleSize& size = {}) {
    const ReferenceCase model(ReferenceCode::find(request).value(), request.block.packedValues(),
                              request.slot.block == nullptr ? std::vector<double>()
                                                            : request.slot.packedValues());
    EvalPlace place;
    place.l = lightAt(degrees);
    double sum = 0.0;
    for (const WeightedDirection& to : hemisphereRule(place.l, size)) {
        place.v = to.v;
        sum += to.weight * std::max(model.evaluate(place)[0], 0.0);
    }
    return sum / place.l.z;
}

} // namespace patina::stability
