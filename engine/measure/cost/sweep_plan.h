// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "measure/cost/cost_chart.h"

namespace patina {

/// Decides which points of a chart are worth measuring, and in which order: the exact one, each
/// level by itself, then combinations of those levels that save time. Where there are fewer than
/// 512 combinations, it takes all of them, the most promising first; else it adds one level at a
/// time, beginning with the exact point.
class SweepPlan {
  public:
    static constexpr std::size_t maxCombinations = 512;

    /// Plans the exact point, `present` where it consists of these choices, and the single levels.
    SweepPlan(std::vector<Choice> choices, bool combinations, ChosenLevels present = {});

    /// Returns the next point, given what was measured; nothing where there is none left.
    std::optional<ChosenLevels> next(const CostChart& chart);

    /// Returns how many more points next() would return that are not on the chart, if all times
    /// were certain.
    std::size_t leftOver(CostChart chart) const;

    /// Returns how many points are planned already.
    std::size_t waiting() const { return waiting_.size(); }

  private:
    using Candidates =
        std::vector<std::vector<std::string>>; ///< are by choice, without the exact one

    void add(ChosenLevels levels);
    bool isMeant(const ChosenLevels& levels) const;
    void addCombinations(const CostChart& chart);
    void addGreedy(const CostChart& chart);
    Candidates gaining(const CostChart& chart) const;

    std::vector<Choice> choices_;
    bool combinations_;
    bool combined_ = false; ///< says whether addCombinations() was called
    bool greedy_ = false;
    ChosenLevels reached_;              ///< is the newest greedy combination
    std::vector<ChosenLevels> waiting_; ///< has the next one at its end
    std::set<ChosenLevels> known_;
};

} // namespace patina
