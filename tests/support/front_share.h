// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "measure/cost_chart.h"

namespace patina::tests {

/// How many points of a chart's front are on that of another chart of the same, or are shown there
/// as ties of one that is.
struct FrontShare {
    std::size_t same = 0;
    std::size_t points = 0;

    double share() const { return points == 0 ? 1.0 : double(same) / double(points); }
};

inline FrontShare frontShare(const CostChart& chart, const CostChart& other) {
    const std::vector<std::size_t> front = costFront(other.points);
    FrontShare share;
    for (const std::size_t i : costFront(chart.points)) {
        const CostPoint* again = other.find(chart.points[i].levels);
        ++share.points;
        share.same += again != nullptr && std::ranges::any_of(front, [&](std::size_t k) {
            const CostPoint& each = other.points[k];
            return each.levels == again->levels ||
                   (tiesInTime(each, *again) && tiesInError(each, *again));
        });
    }
    return share;
}

} // namespace patina::tests
