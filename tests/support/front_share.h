// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "measure/cost/cost_chart.h"

namespace patina::tests {

/// Counts how many points of a chart's front are also on the front of another chart of the same
/// material, or tie with that front there.
struct FrontShare {
    std::size_t same = 0;
    std::size_t points = 0;

    FrontShare& operator+=(const FrontShare& other) {
        same += other.same;
        points += other.points;
        return *this;
    }

    double share() const { return points == 0 ? 1.0 : double(same) / double(points); }
};

inline FrontShare frontShare(const CostChart& chart, const CostChart& other) {
    const std::vector<Standing> standing = standings(other.points);
    FrontShare share;
    for (const std::size_t i : costFront(chart.points)) {
        const auto again =
            std::ranges::find(other.points, chart.points[i].levels, &CostPoint::levels);
        ++share.points;
        share.same += again != other.points.end() &&
                      standing[std::size_t(again - other.points.begin())] != Standing::Beaten;
    }
    return share;
}

} // namespace patina::tests
