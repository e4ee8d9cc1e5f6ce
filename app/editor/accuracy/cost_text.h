// SPDX-License-Identifier: GPL-3.0-or-later
// What people read of a chart of costs.
#pragma once

#include <QString>

#include "measure/cost_chart.h"

namespace patina {

/// "Schlick's fraction + Reduced"; "Exact" where every choice is.
QString wayName(const CostPoint& point, const CostChart& chart);

/// The same in full: which choice has which level, and what that means, line by line.
QString wayDescription(const CostPoint& point, const CostChart& chart);

/// "0.39 %" of a share, with as many digits as tell something.
QString shareText(double share);

/// Three digits: "23.4", "0.0317".
QString digitsText(double number);

/// The name and the numbers of a point, line by line.
QString pointText(const CostPoint& point, const CostChart& chart);

/// How it was measured: pixels, timer, what errors are against.
QString methodText(const CostChart& chart);

} // namespace patina
