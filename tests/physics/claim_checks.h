// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "measure/stability/claim_trials.h"
#include "measure/stability/hemisphere_rule.h"
#include "random_cases.h"

/// This file has what a descriptor may claim, as experiments that can show it to be false.
namespace patina::physics {

using Numbers = std::vector<double>;

/// Is a block with values, and the places that are evaluated together.
struct Trial {
    EvalCase request;
    std::vector<EvalPlace> places;
};

/// Evaluates trials, one place after the other. Values of a model are not cut at 0.
using Evaluate = std::function<std::vector<Numbers>(const std::vector<Trial>&)>;

/// Says how much rounding a claim allows for, and how often it is tried.
struct Care {
    double rounding = 1e-10; ///< is the relative difference of two values that should be equal
    double step = 1e-15;     ///< is the absolute amount by which a value may exceed its bound
    int edgeCaseTrials = 100000;
    int ordinaryTrials = 20000;
    /// Few cases stay in the processor's cache, a device wants many.
    std::size_t casesAtATime = 1 << 8;
};

/// Makes trials of one claim, and judges their values.
struct Experiment {
    int trials = 0;
    std::size_t casesAtATime = 1;
    std::function<Trial()> next;
    std::function<bool(const Trial&, std::span<const Numbers>)> holds;
};

/// Returns the first trial that fails, described.
inline std::optional<std::string> counterexample(const Experiment& experiment,
                                                 const Evaluate& evaluate) {
    int done = 0;
    while (done < experiment.trials) {
        std::vector<Trial> trials;
        std::size_t cases = 0;
        while (done < experiment.trials && cases < experiment.casesAtATime) {
            trials.push_back(experiment.next());
            cases += trials.back().places.size();
            ++done;
        }
        const std::vector<Numbers> answers = evaluate(trials);
        std::span<const Numbers> left = answers;
        for (const Trial& trial : trials) {
            const auto own = left.first(trial.places.size());
            left = left.subspan(own.size());
            if (!experiment.holds(trial, own)) {
                EvalCase first = trial.request;
                static_cast<EvalPlace&>(first) = trial.places.front();
                return described(first, own.front(), own.back());
            }
        }
    }
    return std::nullopt;
}

/// Returns the values that must not be negative: a direction's may be.
inline std::span<const double> signedPart(const EvalCase& request, const Numbers& values) {
    return std::span(values).subspan(signedResultsOf(request));
}

template <class Judge>
Experiment ofEdgeCases(const Block& block, const Care& care, Judge judge) {
    auto cases = std::make_shared<EdgeCases>(block);
    return {care.edgeCaseTrials, care.casesAtATime,
            [cases] {
                const EvalCase request = cases->next();
                return Trial{request, {request}};
            },
            [judge](const Trial& trial, const auto& values) {
                return judge(trial.request, values.front());
            }};
}

inline std::shared_ptr<OrdinaryCases> ordinaryCases(const Block& block) {
    auto ordinary = std::make_shared<OrdinaryCases>(block);
    ordinary->leaveOptionalSlotsEmpty();
    return ordinary;
}

inline Experiment finite(const Block& block, const Care& care) {
    return ofEdgeCases(block, care, [](const EvalCase&, const Numbers& values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    });
}

inline Experiment nonNegative(const Block& block, const Care& care) {
    return ofEdgeCases(block, care, [](const EvalCase& request, const Numbers& values) {
        const auto part = signedPart(request, values);
        return std::all_of(part.begin(), part.end(), [](double x) { return x >= 0.0; });
    });
}

inline Experiment zeroBelowHorizon(const Block& block, const Care& care) {
    return ofEdgeCases(block, care, [](const EvalCase& request, const Numbers& values) {
        return (request.l.z > 0.0 && request.v.z > 0.0) || values[0] == 0.0;
    });
}

/// Checks that f(l, v) = f(v, l), with f = value / (n.l).
inline Experiment reciprocal(const Block& block, const Care& care) {
    auto ordinary = ordinaryCases(block);
    return {care.ordinaryTrials, care.casesAtATime,
            [ordinary] {
                const EvalCase request = ordinary->next();
                EvalPlace exchanged = request;
                std::swap(exchanged.l, exchanged.v);
                return Trial{request, {request, exchanged}};
            },
            [care](const Trial& trial, const auto& values) {
                const double there = values[0][0] / glm::normalize(trial.request.l).z;
                const double back = values[1][0] / glm::normalize(trial.request.v).z;
                return std::abs(there - back) <= care.rounding * (1.0 + there);
            }};
}

inline glm::dvec3 turned(const glm::dvec3& v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle),
            v.x * std::sin(angle) + v.y * std::cos(angle), v.z};
}

/// Checks that the value does not change when light and viewer are turned together about the
/// normal.
inline Experiment isotropic(const Block& block, const Care& care) {
    auto ordinary = ordinaryCases(block);
    auto turn = std::make_shared<double>(0.7);
    return {care.ordinaryTrials, care.casesAtATime,
            [ordinary, turn] {
                const EvalCase request = ordinary->next();
                EvalPlace rotated = request;
                rotated.l = turned(request.l, *turn);
                rotated.v = turned(request.v, *turn);
                *turn += 1.0;
                return Trial{request, {request, rotated}};
            },
            [care](const auto&, const auto& values) {
                return std::abs(values[0][0] - values[1][0]) <=
                       care.rounding * (1.0 + values[0][0]);
            }};
}

/// Finds lobes as sharp as sliders make them, and what gathers at the horizon, within 1e-3.
inline constexpr HemisphereRuleSize albedoRule{3, 0.5};

/// Makes a trial of the case for viewers all over the hemisphere.
inline Trial fromEverywhere(const EvalCase& request) {
    Trial trial{request, {}};
    EvalPlace place = request;
    for (const WeightedDirection& to : hemisphereRule(request.l, albedoRule)) {
        place.v = to.v;
        trial.places.push_back(place);
    }
    return trial;
}

/// Returns the directional albedo by the values of fromEverywhere().
inline double albedo(const Trial& trial, std::span<const Numbers> values) {
    const auto rule = hemisphereRule(trial.request.l, albedoRule);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        sum += rule[i].weight * values[i][0];
    }
    return sum / glm::normalize(trial.request.l).z;
}

/// Checks that no more light comes back than arrives: the albedo is at most 1, and so is a share.
inline Experiment energyConserving(const Block& block, const Care& care) {
    if (block.kind != "models" && block.kind != "specular") {
        return ofEdgeCases(block, care,
                           [](const EvalCase&, const Numbers& values) { return values[0] <= 1.0; });
    }
    auto ordinary = ordinaryCases(block);
    return {
        care.ordinaryTrials / 400, care.casesAtATime,
        [ordinary] { return fromEverywhere(brightest(ordinary->next())); },
        [](const Trial& trial, const auto& values) { return albedo(trial, values) <= 1.0 + 1e-3; }};
}

/// Checks that at 1e-7 rad above the horizon the value is at most a thousandth of what the same
/// light gives higher up.
inline Experiment continuousAtHorizon(const Block& block, const Care& care) {
    auto ordinary = ordinaryCases(block);
    auto turn = std::make_shared<double>(0.0);
    return {care.ordinaryTrials / 10, care.casesAtATime,
            [ordinary, turn] {
                EvalCase request = brightest(ordinary->next());
                request.v = direction(60.0, 37.0 * *turn);
                request.l = {std::cos(*turn), std::sin(*turn), 1e-7};
                Trial trial{request, {request}};
                for (const double degrees : {0.0, 20.0, 40.0, 60.0, 80.0}) {
                    request.l = direction(degrees, 37.0 * *turn + 180.0);
                    trial.places.push_back(request);
                }
                *turn += 1.0;
                return trial;
            },
            [](const auto&, const auto& values) {
                double largest = 0.0;
                for (std::size_t i = 1; i < values.size(); ++i) {
                    largest = std::max(largest, values[i][0]);
                }
                return values[0][0] <= 1e-3 * largest + 1e-12;
            }};
}

/// Checks a Fresnel block: what is reflected does not fall as light becomes more grazing.
inline Experiment monotonic(const Block& block, const Care& care) {
    auto cases = std::make_shared<EdgeCases>(block);
    return {care.edgeCaseTrials / 100, care.casesAtATime,
            [cases] {
                const EvalCase request = cases->next();
                Trial trial{request, std::vector<EvalPlace>(101, request)};
                for (std::size_t i = 0; i < trial.places.size(); ++i) {
                    trial.places[i].number = 1.0 - 0.01 * static_cast<double>(i);
                }
                return trial;
            },
            [care](const auto&, const auto& values) {
                return std::is_sorted(
                    values.begin(), values.end(),
                    [care](const Numbers& a, const Numbers& b) { return a[0] < b[0] - care.step; });
            }};
}

struct Claim {
    const char* name;
    Experiment (*experiment)(const Block&, const Care&);
};

inline constexpr std::array<Claim, 8> claims{{{"finite", finite},
                                              {"non_negative", nonNegative},
                                              {"reciprocal", reciprocal},
                                              {"energy_conserving", energyConserving},
                                              {"isotropic", isotropic},
                                              {"zero_below_horizon", zeroBelowHorizon},
                                              {"continuous_at_horizon", continuousAtHorizon},
                                              {"monotonic", monotonic}}};

} // namespace patina::physics
