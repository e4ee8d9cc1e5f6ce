// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mapped_point.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {

Result<const CostPoint*> mappedPoint(const CostChart& chart, const CostRequest& options) {
    if (!options.errorMapOf.empty()) {
        const auto named = std::ranges::find_if(chart.points, [&](const CostPoint& point) {
            return levelsText(point.levels) == options.errorMapOf;
        });
        return named != chart.points.end()
                   ? Result<const CostPoint*>(&*named)
                   : failure(fmt::format("\"{}\" was not measured", options.errorMapOf),
                             "a way as the table names it");
    }
    const auto answer =
        bestFor({options.budgetMilliseconds, options.budgetError}, chart.points);
    if (options.hasBudget() && answer) {
        return &chart.points[answer->point];
    }
    const CostPoint& fastest = chart.points[costFront(chart.points).front()];
    return fastest.isExact() ? &*std::ranges::max_element(chart.points, {}, errorOf) : &fastest;
}

} // namespace patina
