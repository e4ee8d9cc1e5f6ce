// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <vector>

#include "measure/eval/reference_case.h"
#include "measure/stability/hemisphere_rule.h"

namespace patina::stability {

/// Returns the direction of light from `degrees` off the normal.
inline glm::dvec3 lightAt(double degrees) {
    const double theta = degrees * std::numbers::pi / 180.0;
    return {std::sin(theta), 0.0, std::cos(theta)};
}

/// Is the geometry of light from one direction and one viewer, and the viewer's weight.
struct WeightedGeometry {
    reference::Geometry geometry;
    double weight = 0.0;
};

/// Returns viewers all over the hemisphere, for light from `degrees` off the normal. They are the
/// same for every model, and making them takes as long as evaluating a simple one.
inline const std::vector<WeightedGeometry>& viewersFor(double degrees,
                                                       const HemisphereRuleSize& size) {
    static std::map<std::tuple<double, int, double>, std::vector<WeightedGeometry>> made;
    std::vector<WeightedGeometry>& viewers = made[{degrees, size.nodes, size.widestPanel}];
    if (viewers.empty()) {
        EvalPlace place;
        place.l = lightAt(degrees);
        for (const WeightedDirection& to : hemisphereRule(place.l, size)) {
            place.v = to.v;
            viewers.push_back({geometryOf(place), to.weight});
        }
    }
    return viewers;
}

/// Returns the directional albedo for light from `degrees` off the normal, by the first channel in
/// double precision.
inline double albedo(const EvalCase& request, double degrees, const HemisphereRuleSize& size = {}) {
    const ReferenceCase model(ReferenceCode::find(request).value(), request.block.packedValues(),
                              request.slot.block == nullptr ? std::vector<double>()
                                                            : request.slot.packedValues());
    double sum = 0.0;
    for (const auto& [geometry, weight] : viewersFor(degrees, size)) {
        sum += weight * std::max(model.evaluate(geometry)[0], 0.0);
    }
    return sum / lightAt(degrees).z;
}

} // namespace patina::stability
