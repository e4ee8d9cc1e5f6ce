// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/value_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace patina {
namespace {

using Subject = EvalCase::Subject;

/// Returns the sine of the angle below the surface; about a normal that is no axis a cosine of 0 is
/// known to a few roundings only, so that a direction in the surface may count as above.
bool isBelowHorizon(const glm::dvec3& n, const glm::dvec3& direction) {
    const bool axis = n.x == 0.0 && n.y == 0.0;
    return glm::dot(glm::normalize(n), glm::normalize(direction)) <= (axis ? 0.0 : -1e-6);
}

} // namespace

ValueChecks::ValueChecks(const EvalCase& variant)
    : numbers_(resultsOf(variant)), signed_(signedResultsOf(variant)),
      darkBelow_(variant.subject == Subject::Model &&
                 variant.block.block->hasClaim("zero_below_horizon")) {}

bool ValueChecks::belowHorizon(const EvalPlace& place) const {
    return isBelowHorizon(place.n, place.l) || isBelowHorizon(place.n, place.v);
}

std::optional<Defect> ValueChecks::check(const EvalPlace& place, std::span<const double> numbers,
                                         double& excess) const {
    excess = std::numeric_limits<double>::infinity();
    if (std::any_of(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); })) {
        return Defect::NotANumber;
    }
    if (std::any_of(numbers.begin(), numbers.end(), [](double x) { return std::isinf(x); })) {
        return Defect::Infinite;
    }
    const auto magnitudes = numbers.subspan(signed_);
    if (magnitudes.empty()) {
        return std::nullopt;
    }
    const auto [smallest, largest] = std::minmax_element(magnitudes.begin(), magnitudes.end());
    excess = -*smallest;
    if (*smallest < 0.0) {
        return Defect::Negative;
    }
    excess = *largest;
    if (darkBelow_ && *largest > 0.0 && belowHorizon(place)) {
        return Defect::BelowHorizon;
    }
    return std::nullopt;
}

} // namespace patina
