// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/cost_chart.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "measure/choice/pass_choices.h"

namespace patina {
namespace {

/// Is the relative difference within which measured times are taken for equal, as are those whose
/// intervals meet.
constexpr double timeNoise = 0.03;

/// Is the error below which a point is as good as exact, since it is the rounding of floats.
constexpr double minError = 1e-6;
constexpr double errorNoise = 0.02;

double timeOf(const CostPoint& point) {
    return point.cost.ratio.median;
}

/// Returns the interval of the ratio to the exact frame. That of the exact frame to itself is a
/// point, since the other ratios already have its noise.
MedianInterval intervalOf(const CostPoint& point) {
    const double time = timeOf(point);
    return point.isExact() ? MedianInterval{time, time, time} : point.cost.ratio;
}

/// Lists the levels that are drawn as a given one.
struct SameNames {
    std::string names; ///< are those of the other levels
    int count = 0;
    int samples = 0; ///< is a SameLevel::samples
};

SameNames namesOfSame(const std::vector<SameLevel>& same, const Choice& choice,
                      const ChoiceLevel& level) {
    SameNames found;
    for (const SameLevel& each : same) {
        const ChoiceLevel* other = choice.level(each.level);
        if (each.choice == choice.id && each.as == level.id && other != nullptr) {
            found.names += (found.count++ > 0 ? ", " : "") + other->label;
            found.samples = each.samples;
        }
    }
    return found;
}

/// Returns a sentence that names levels which are drawn alike. For samples it says how many the
/// device takes, which may be none of these levels.
std::string sentenceOf(const SameNames& same, const Choice& choice, const ChoiceLevel& level) {
    if (same.samples > 0) {
        return fmt::format("{}: {}, {} are {} drawn with {} here", choice.label, level.label,
                           same.names, same.count > 1 ? "all" : "both", same.samples);
    }
    return fmt::format("{}: {} {} drawn as {}", choice.label, same.names,
                       same.count > 1 ? "are" : "is", level.label);
}

double knownError(const CostPoint& point) {
    return std::max(errorOf(point), minError);
}

bool isFaster(const CostPoint& a, const CostPoint& b) {
    return timeOf(a) < timeOf(b) && !tiesInTime(a, b);
}

/// Tells whether `a` is more accurate, or as accurate and the exact one, or else the faster one.
bool comesBefore(const CostPoint& a, const CostPoint& b) {
    if (knownError(a) != knownError(b)) {
        return knownError(a) < knownError(b);
    }
    return a.isExact() != b.isExact() ? a.isExact() : timeOf(a) < timeOf(b);
}

/// Tells whether a point is faster than all of the front that have no larger error, even if only by
/// the noise.
bool isNearlyFaster(const CostPoint& point, const std::vector<CostPoint>& points,
                    const std::vector<std::size_t>& front) {
    return std::ranges::all_of(front, [&](std::size_t before) {
        return !comesBefore(points[before], point) || timeOf(point) < timeOf(points[before]);
    });
}

bool fits(const CostBudget& budget, const CostPoint& point) {
    return (!budget.milliseconds || point.cost.milliseconds.median <= *budget.milliseconds) &&
           (!budget.error || errorOf(point) <= *budget.error);
}

/// Returns the largest share of the budget that a point takes; above 1 where it exceeds it.
double excess(const CostBudget& budget, const CostPoint& point) {
    double largest = 0.0;
    if (budget.milliseconds) {
        largest = std::max(largest, point.cost.milliseconds.median / *budget.milliseconds);
    }
    if (budget.error) {
        largest = std::max(largest, errorOf(point) / std::max(*budget.error, 1e-30));
    }
    return largest;
}

/// Chooses among points that fit: the most accurate one for a budget of time, else the fastest one.
std::size_t bought(const CostBudget& budget, const std::vector<CostPoint>& points,
                   const std::vector<std::size_t>& fitting) {
    const auto time = [&points](std::size_t i) { return timeOf(points[i]); };
    const auto error = [&points](std::size_t i) { return errorOf(points[i]); };
    const bool buysAccuracy = budget.milliseconds.has_value();
    const std::size_t best = buysAccuracy ? *std::ranges::min_element(fitting, {}, error)
                                          : *std::ranges::min_element(fitting, {}, time);
    std::vector<std::size_t> alike;
    std::ranges::copy_if(fitting, std::back_inserter(alike), [&](std::size_t i) {
        return buysAccuracy ? tiesInError(points[i], points[best])
                            : tiesInTime(points[i], points[best]);
    });
    return buysAccuracy ? *std::ranges::min_element(alike, {}, time)
                        : *std::ranges::min_element(alike, {}, error);
}

/// Chooses among points of which none fits the one that exceeds the budget least; for a budget of
/// time alone, the most accurate of those that tie with it in time.
std::size_t nearest(const CostBudget& budget, const std::vector<CostPoint>& points,
                    const std::vector<std::size_t>& all) {
    const auto over = [&](std::size_t i) { return excess(budget, points[i]); };
    const auto error = [&points](std::size_t i) { return errorOf(points[i]); };
    const std::size_t smallest = *std::ranges::min_element(all, {}, over);
    if (!budget.milliseconds || budget.error) {
        return smallest;
    }
    std::vector<std::size_t> alike;
    std::ranges::copy_if(all, std::back_inserter(alike),
                         [&](std::size_t i) { return tiesInTime(points[i], points[smallest]); });
    return *std::ranges::min_element(alike, {}, error);
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
            const SameNames same = namesOfSame(chart.same, choice, level);
            if (same.count > 0) {
                text += (text.empty() ? "" : "; ") + sentenceOf(same, choice, level);
            }
        }
    }
    return text;
}

bool CostChart::isAgainstConverged(const CostPoint& point) const {
    return converged && point.levels.contains(converged->choice) && !hasPassLevel(point.levels);
}

RatioBound CostChart::boundOf(const CostPoint& point) const {
    return points.empty() ? RatioBound::None : patina::boundOf(point.cost, points.front().cost);
}

std::string leftOutText(const CostChart& chart) {
    return chart.leftOut == 0 ? ""
                              : fmt::format("{} {} left out for want of time", chart.leftOut,
                                            chart.leftOut == 1 ? "combination of choices was"
                                                               : "combinations of choices were");
}

std::string convergedText(const CostChart& chart) {
    if (!chart.converged) {
        return {};
    }
    const ConvergedRender& render = *chart.converged;
    return fmt::format("with fewer directions against a converged render of {} other directions "
                       "per pixel, 99 of 100 pixels of which are right to {:.1e}; the exact frame "
                       "differs from it by {:.1e}",
                       render.directions, render.noise.p99, render.finest.p99);
}

double errorOf(const CostPoint& point) {
    return point.error.p99;
}

bool tiesInTime(const CostPoint& a, const CostPoint& b) {
    if (a.cost.isGiven() && b.cost.isGiven()) {
        return timeOf(a) == timeOf(b);
    }
    if (!a.cost.isSure() || !b.cost.isSure()) {
        return true;
    }
    const MedianInterval x = intervalOf(a);
    const MedianInterval y = intervalOf(b);
    const bool meet = x.lower <= y.upper && y.lower <= x.upper;
    return meet || std::abs(x.median - y.median) <= timeNoise * std::max(x.median, y.median);
}

bool tiesInError(const CostPoint& a, const CostPoint& b) {
    const double x = knownError(a);
    const double y = knownError(b);
    return x == y || std::abs(x - y) <= errorNoise * std::max(x, y);
}

std::vector<std::size_t> tiesOf(const std::vector<CostPoint>& points, const CostPoint& point) {
    std::vector<std::size_t> ties;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (points[i].levels != point.levels && tiesInTime(points[i], point) &&
            tiesInError(points[i], point)) {
            ties.push_back(i);
        }
    }
    return ties;
}

std::vector<std::size_t> costFront(const std::vector<CostPoint>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, [&points](std::size_t a, std::size_t b) {
        return comesBefore(points[a], points[b]);
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (!std::ranges::all_of(front, [&points, i](std::size_t before) {
                return isFaster(points[i], points[before]);
            })) {
            continue;
        }
        // Both are as accurate and this one is faster: the one before is the exact one.
        if (!front.empty() && knownError(points[front.back()]) == knownError(points[i])) {
            front.pop_back();
        }
        front.push_back(i);
    }
    std::ranges::reverse(front);
    return front;
}

std::vector<Standing> standings(const std::vector<CostPoint>& points) {
    const std::vector<std::size_t> front = costFront(points);
    std::vector<Standing> standings(points.size(), Standing::Beaten);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (isNearlyFaster(points[i], points, front)) {
            standings[i] = Standing::Tie;
        }
    }
    for (const std::size_t i : front) {
        for (const std::size_t other : tiesOf(points, points[i])) {
            standings[other] = Standing::Tie;
        }
    }
    for (const std::size_t i : front) {
        standings[i] = Standing::OnFront;
    }
    return standings;
}

std::vector<std::size_t> frontAndTies(const std::vector<CostPoint>& points) {
    std::vector<std::size_t> both = costFront(points);
    const std::vector<Standing> standing = standings(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (standing[i] == Standing::Tie) {
            both.push_back(i);
        }
    }
    return both;
}

std::optional<BudgetAnswer> bestFor(const CostBudget& budget,
                                    const std::vector<CostPoint>& points) {
    std::vector<std::size_t> all(points.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    std::vector<std::size_t> fitting;
    std::ranges::copy_if(all, std::back_inserter(fitting),
                         [&](std::size_t i) { return fits(budget, points[i]); });
    if (!fitting.empty()) {
        return BudgetAnswer{bought(budget, points, fitting), true};
    }
    if (all.empty()) {
        return std::nullopt;
    }
    return BudgetAnswer{nearest(budget, points, all), false};
}

} // namespace patina
