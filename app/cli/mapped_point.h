// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/cost_request.h"
#include "measure/cost/cost_chart.h"

namespace patina {

/// Returns the levels of --error-map-of, without those that are exact; none where it is not given.
/// Fails where a level is not one of these choices.
Result<ChosenLevels> namedLevels(const std::vector<Choice>& choices, const CostRequest& options);

/// Returns the point whose errors are drawn: the one that is named, which has been measured, or the
/// one that the budget selects, or else the fastest one on the front. Where that is the exact one,
/// whose map would be black, it returns the one with the largest error.
const CostPoint& mappedPoint(const CostChart& chart, const ChosenLevels& named,
                             const CostRequest& options);

} // namespace patina
