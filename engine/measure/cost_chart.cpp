// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost_chart.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace patina {
namespace {

/// Times within this share of each other are taken for equal, as are those whose intervals meet.
constexpr double timeNoise = 0.03;

/// Below this an error is the rounding of floats, and everything as good as exact.
constexpr double leastError = 1e-6;
constexpr double errorNoise = 0.02;

double timeOf(const CostPoint& point) {
    return point.cost.ratio.median;
}

/// What is drawn as this level is, by name.
std::string namesOfSame(const std::vector<SameLevel>& same, const Choice& choice,
                        const ChoiceLevel& level) {
    std::string names;
    for (const SameLevel& each : same) {
        const ChoiceLevel* other = choice.level(each.level);
        if (each.choice == choice.id && each.as == level.id && other != nullptr) {
            names += (names.empty() ? "" : ", ") + other->label;
        }
    }
    return names;
}

double knownError(const CostPoint& point) {
    return std::max(errorOf(point), leastError);
}

bool isFaster(const CostPoint& a, const CostPoint& b) {
    return timeOf(a) < timeOf(b) && !tiesInTime(a, b);
}

bool isRighter(const CostPoint& a, const CostPoint& b) {
    return errorOf(a) < errorOf(b) && !tiesInError(a, b);
}

/// `a` is better in one respect and in the other no worse.
bool beats(const CostPoint& a, const CostPoint& b) {
    return (isFaster(a, b) && !isRighter(b, a)) || (isRighter(a, b) && !isFaster(b, a));
}

bool fits(const CostBudget& budget, const CostPoint& point) {
    return (!budget.milliseconds || point.cost.milliseconds.median <= *budget.milliseconds) &&
           (!budget.error || errorOf(point) <= *budget.error);
}

/// How far beyond the budget a point is.
double excess(const CostBudget& budget, const CostPoint& point) {
    double most = 0.0;
    if (budget.milliseconds) {
        most = std::max(most, point.cost.milliseconds.median / *budget.milliseconds);
    }
    if (budget.error) {
        most = std::max(most, errorOf(point) / std::max(*budget.error, 1e-30));
    }
    return most;
}

/// Among points that fit: a budget of time buys accuracy, one of error buys time.
bool isPreferred(const CostBudget& budget, const CostPoint& a, const CostPoint& b) {
    if (budget.milliseconds) {
        return tiesInError(a, b) ? timeOf(a) < timeOf(b) : errorOf(a) < errorOf(b);
    }
    return tiesInTime(a, b) ? errorOf(a) < errorOf(b) : timeOf(a) < timeOf(b);
}

} // namespace

ChosenLevels CostChart::distinct(ChosenLevels levels) const {
    for (const SameLevel& each : same) {
        const auto chosen = levels.find(each.choice);
        if (chosen == levels.end() || chosen->second != each.level) {
            continue;
        }
        const auto choice = std::ranges::find(choices, each.choice, &Choice::id);
        const bool isExact = choice != choices.end() && choice->levels.front().id == each.as;
        if (isExact) {
            levels.erase(chosen);
        } else {
            chosen->second = each.as;
        }
    }
    return levels;
}

const CostPoint* CostChart::find(const ChosenLevels& levels) const {
    const auto found = std::ranges::find(points, distinct(levels), &CostPoint::levels);
    return found == points.end() ? nullptr : &*found;
}

std::string sameText(const CostChart& chart) {
    std::string text;
    for (const Choice& choice : chart.choices) {
        for (const ChoiceLevel& level : choice.levels) {
            const std::string names = namesOfSame(chart.same, choice, level);
            if (!names.empty()) {
                text += fmt::format("{}{}: {} are drawn as {}", text.empty() ? "" : "; ",
                                    choice.label, names, level.label);
            }
        }
    }
    return text;
}

double errorOf(const CostPoint& point) {
    return point.error.p99;
}

bool tiesInTime(const CostPoint& a, const CostPoint& b) {
    const MedianInterval& x = a.cost.ratio;
    const MedianInterval& y = b.cost.ratio;
    const bool meet = x.lower <= y.upper && y.lower <= x.upper;
    return meet || std::abs(x.median - y.median) <= timeNoise * std::max(x.median, y.median);
}

bool tiesInError(const CostPoint& a, const CostPoint& b) {
    const double x = knownError(a);
    const double y = knownError(b);
    return x == y || std::abs(x - y) <= errorNoise * std::max(x, y);
}

std::vector<std::size_t> costFront(const std::vector<CostPoint>& points) {
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::ranges::none_of(points, [&points, i](const CostPoint& other) {
                return beats(other, points[i]);
            })) {
            front.push_back(i);
        }
    }
    std::ranges::stable_sort(front, [&points](std::size_t a, std::size_t b) {
        return timeOf(points[a]) < timeOf(points[b]);
    });
    return front;
}

std::optional<BudgetAnswer> bestFor(const CostBudget& budget,
                                    const std::vector<CostPoint>& points) {
    std::optional<BudgetAnswer> best;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool fit = fits(budget, points[i]);
        const bool better =
            !best || (fit && !best->fits) ||
            (fit && isPreferred(budget, points[i], points[best->point])) ||
            (!fit && !best->fits &&
             excess(budget, points[i]) < excess(budget, points[best->point]));
        if (better) {
            best = BudgetAnswer{i, fit};
        }
    }
    return best;
}

} // namespace patina
