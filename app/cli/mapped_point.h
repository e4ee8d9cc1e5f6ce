// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/cost_request.h"
#include "measure/cost/cost_chart.h"

namespace patina {

/// The levels of --error-map-of, without those that are exact; none where it is not given. The
/// error names what is no level of these choices.
Result<ChosenLevels> namedWay(const std::vector<Choice>& choices, const CostRequest& options);

/// The point whose errors are drawn: the one of the way that is named, which has been measured, or
/// the one that the budget buys, or else the fastest one that is worth choosing; where that is the
/// exact one, whose map is black, the one that is off by most.
const CostPoint& mappedPoint(const CostChart& chart, const ChosenLevels& named,
                             const CostRequest& options);

} // namespace patina
