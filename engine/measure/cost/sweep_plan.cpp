// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/sweep_plan.h"

#include <algorithm>

namespace patina {
namespace {

/// Predicts a combination as if the ratios of its levels multiplied and their errors added up.
struct Promise {
    double time = 1.0;
    double error = 0.0;
};

Promise promiseOf(const ChosenLevels& levels, const CostChart& chart) {
    Promise promise;
    for (const auto& [choice, level] : levels) {
        if (const CostPoint* single = chart.find({{choice, level}})) {
            promise.time *= single->cost.ratio.median;
            promise.error += errorOf(*single);
        }
    }
    return promise;
}

std::size_t product(const std::vector<std::vector<std::string>>& candidates) {
    std::size_t count = 1;
    for (const std::vector<std::string>& levels : candidates) {
        count = std::min(count * (levels.size() + 1), SweepPlan::maxCombinations);
    }
    return count;
}

} // namespace

SweepPlan::SweepPlan(std::vector<Choice> choices, bool combinations, ChosenLevels present)
    : choices_(std::move(choices)), combinations_(combinations) {
    for (auto choice = choices_.rbegin(); choice != choices_.rend(); ++choice) {
        for (std::size_t i = choice->levels.size(); i-- > 1;) {
            add({{choice->id, choice->levels[i].id}});
        }
    }
    if (isMeant(present)) {
        add(std::move(present));
    }
    add({});
}

/// Tells whether all levels are among those of the choices.
bool SweepPlan::isMeant(const ChosenLevels& levels) const {
    return std::ranges::all_of(levels, [this](const auto& level) {
        return std::ranges::any_of(choices_, [&level](const Choice& choice) {
            return choice.id == level.first && choice.level(level.second) != nullptr;
        });
    });
}

void SweepPlan::add(ChosenLevels levels) {
    if (known_.insert(levels).second) {
        waiting_.push_back(std::move(levels));
    }
}

std::optional<ChosenLevels> SweepPlan::next(const CostChart& chart) {
    if (waiting_.empty() && combinations_) {
        if (!combined_) {
            addCombinations(chart);
        } else if (greedy_) {
            addGreedy(chart);
        }
    }
    if (waiting_.empty()) {
        return std::nullopt;
    }
    ChosenLevels levels = std::move(waiting_.back());
    waiting_.pop_back();
    return levels;
}

/// Takes uncertain times for certain ones: else they tie with too many, and too little seems to
/// gain.
std::size_t SweepPlan::leftOver(CostChart chart) const {
    for (CostPoint& point : chart.points) {
        if (!point.cost.settled) {
            const double ratio = point.cost.ratio.median;
            point.cost.ratio = {ratio, ratio, ratio};
            point.cost.runs = 0; // as if it were given
        }
    }
    SweepPlan rest = *this;
    std::size_t count = 0;
    while (const std::optional<ChosenLevels> levels = rest.next(chart)) {
        count += chart.find(*levels) == nullptr ? 1 : 0;
    }
    return count;
}

/// Returns for each choice the levels that are faster than the exact one and on the front of the
/// choice: what gains nothing by itself is taken to gain nothing in a combination.
SweepPlan::Candidates SweepPlan::gaining(const CostChart& chart) const {
    Candidates candidates;
    const CostPoint* exact = chart.find({});
    for (const Choice& choice : choices_) {
        std::vector<CostPoint> points{*exact};
        for (std::size_t i = 1; i < choice.levels.size(); ++i) {
            if (const CostPoint* point = chart.find({{choice.id, choice.levels[i].id}})) {
                points.push_back(*point);
            }
        }
        candidates.emplace_back();
        for (const std::size_t i : costFront(points)) {
            const bool gains = points[i].cost.ratio.median < 1.0 && !tiesInTime(points[i], *exact);
            if (i > 0 && gains) {
                candidates.back().push_back(points[i].levels.begin()->second);
            }
        }
    }
    return candidates;
}

void SweepPlan::addCombinations(const CostChart& chart) {
    combined_ = true;
    if (chart.find({}) == nullptr) {
        return;
    }
    const Candidates candidates = gaining(chart);
    if (product(candidates) >= maxCombinations) {
        greedy_ = true;
        addGreedy(chart);
        return;
    }
    std::vector<ChosenLevels> all{{}};
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        const std::size_t count = all.size();
        for (const std::string& level : candidates[c]) {
            for (std::size_t i = 0; i < count; ++i) {
                all.push_back(all[i]);
                all.back()[choices_[c].id] = level;
            }
        }
    }
    // Of two that promise the same time the more accurate one comes first.
    std::ranges::stable_sort(all, [&chart](const ChosenLevels& a, const ChosenLevels& b) {
        const Promise x = promiseOf(a, chart);
        const Promise y = promiseOf(b, chart);
        return x.time * (1.0 + x.error) > y.time * (1.0 + y.error);
    });
    for (ChosenLevels& levels : all) {
        add(std::move(levels));
    }
}

/// Adds one more level to the greedy combination: the one that saves most time for its error.
void SweepPlan::addGreedy(const CostChart& chart) {
    const Candidates candidates = gaining(chart);
    std::optional<ChosenLevels> best;
    double maxGain = 0.0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        for (const std::string& level : candidates[c]) {
            const CostPoint* single = chart.find({{choices_[c].id, level}});
            const double saved = 1.0 - single->cost.ratio.median;
            const double gain = saved / (1e-6 + errorOf(*single));
            if (!reached_.contains(choices_[c].id) && gain > maxGain) {
                maxGain = gain;
                best = reached_;
                (*best)[choices_[c].id] = level;
            }
        }
    }
    greedy_ = best.has_value();
    if (best) {
        reached_ = *best;
        if (reached_.size() > 1) {
            add(reached_);
        } else {
            addGreedy(chart); // a single level has been measured already
        }
    }
}

} // namespace patina
