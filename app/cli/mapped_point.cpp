// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mapped_point.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace patina {

Result<ChosenLevels> namedLevels(const std::vector<Choice>& choices, const CostRequest& options) {
    if (options.errorMapOf.empty()) {
        return ChosenLevels();
    }
    const std::optional<ChosenLevels> named = levelsFromText(options.errorMapOf);
    if (!named) {
        return failure(fmt::format("--error-map-of \"{}\" names no way", options.errorMapOf),
                       "\"exact\", or a level of each choice: \"<choice>=<level> ...\"");
    }
    ChosenLevels way;
    for (const auto& [id, level] : *named) {
        const auto choice = std::ranges::find(choices, id, &Choice::id);
        if (choice == choices.end() || choice->level(level) == nullptr) {
            std::string known;
            for (const Choice& each : choices) {
                for (const ChoiceLevel& other : each.levels) {
                    known += fmt::format("{}{}={}", known.empty() ? "" : ", ", each.id, other.id);
                }
            }
            return failure(fmt::format("--error-map-of: there is no {}={} here", id, level),
                           known.empty() ? "exact" : known);
        }
        if (level != choice->levels.front().id) {
            way[id] = level;
        }
    }
    return way;
}

const CostPoint& mappedPoint(const CostChart& chart, const ChosenLevels& named,
                             const CostRequest& options) {
    if (const CostPoint* point = options.errorMapOf.empty() ? nullptr : chart.find(named)) {
        return *point;
    }
    const auto answer = bestFor({options.budgetMilliseconds, options.budgetError}, chart.points);
    if (options.hasBudget() && answer) {
        return chart.points[answer->point];
    }
    const CostPoint& fastest = chart.points[costFront(chart.points).front()];
    const auto howWrong = [](const CostPoint& point) {
        return std::pair(errorOf(point), point.error.max);
    };
    return fastest.isExact() ? *std::ranges::max_element(chart.points, {}, howWrong) : fastest;
}

} // namespace patina
