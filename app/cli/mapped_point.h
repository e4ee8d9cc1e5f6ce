// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/cost_request.h"
#include "measure/cost_chart.h"

namespace patina {

/// The point whose errors are drawn. Unless it is named or bought it is the fastest one that is
/// worth choosing, or where that is the exact one, whose map is black, the one that is off by most.
/// The error says that none has the name.
Result<const CostPoint*> mappedPoint(const CostChart& chart, const CostRequest& options);

} // namespace patina
