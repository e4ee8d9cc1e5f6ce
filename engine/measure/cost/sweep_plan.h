// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "measure/cost/cost_chart.h"

namespace patina {

/// Decides which points of a chart are worth measuring, and in which order: the exact one, each
/// level by itself, then combinations of those levels that gain something. All of them where they
/// are fewer than 512, those that promise most first; else one level more at a time, from the exact
/// point on.
class SweepPlan {
  public:
    static constexpr std::size_t maxCombinations = 512;

    /// `present` is measured in any case, after the exact point.
    SweepPlan(std::vector<Choice> choices, bool combinations, ChosenLevels present = {});

    /// Returns the next point, given what was measured; nothing: all are.
    std::optional<ChosenLevels> next(const CostChart& chart);

    /// Returns how many points it would name that are not on the chart, if all times were sure.
    std::size_t leftOver(CostChart chart) const;

    /// Returns how many are known to be still to come.
    std::size_t waiting() const { return waiting_.size(); }

  private:
    using Candidates = std::vector<std::vector<std::string>>; ///< by choice, without the exact one

    void add(ChosenLevels levels);
    bool isMeant(const ChosenLevels& levels) const;
    void addCombinations(const CostChart& chart);
    void addGreedy(const CostChart& chart);
    Candidates gaining(const CostChart& chart) const;

    std::vector<Choice> choices_;
    bool combinations_;
    bool combined_ = false; ///< whether addCombinations() was called
    bool greedy_ = false;
    ChosenLevels reached_;              ///< where the greedy way is
    std::vector<ChosenLevels> waiting_; ///< the next one last
    std::set<ChosenLevels> known_;
};

} // namespace patina
