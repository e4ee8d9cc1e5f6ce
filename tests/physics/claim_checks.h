// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include <glm/geometric.hpp>

#include "measure/stability/hemisphere_rule.h"
#include "random_cases.h"

/// What a descriptor may claim, as experiments that can show it to be false.
namespace patina::physics {

using Numbers = std::vector<double>;

/// Evaluates cases and keeps their order. What a model returns is not cut at 0.
using Evaluate = std::function<std::vector<Numbers>(const std::vector<EvalCase>&)>;

/// What a claim allows for: the rounding of what is evaluated, and how often it is tried.
struct Care {
    double rounding = 1e-10; ///< relative, of two values that should be equal
    double step = 1e-15;     ///< absolute, that a value may be beyond one that bounds it
    int edgeCaseTrials = 100000;
    int ordinaryTrials = 20000;
};

/// Trials of one claim: each asks for some cases and judges their values.
struct Experiment {
    int trials = 0;
    std::function<std::vector<EvalCase>()> next;
    std::function<bool(const std::vector<EvalCase>&, const std::vector<Numbers>&)> holds;
};

/// The first trial that fails, described.
inline std::optional<std::string> counterexample(const Experiment& experiment,
                                                 const Evaluate& evaluate) {
    constexpr std::size_t casesAtATime = 1 << 15;
    int done = 0;
    while (done < experiment.trials) {
        std::vector<std::vector<EvalCase>> trials;
        std::vector<EvalCase> all;
        while (done < experiment.trials && all.size() < casesAtATime) {
            trials.push_back(experiment.next());
            all.insert(all.end(), trials.back().begin(), trials.back().end());
            ++done;
        }
        const std::vector<Numbers> answers = evaluate(all);
        auto from = answers.begin();
        for (const auto& cases : trials) {
            const std::vector<Numbers> own(from, from + std::ptrdiff_t(cases.size()));
            from += std::ptrdiff_t(cases.size());
            if (!experiment.holds(cases, own)) {
                return described(cases.front(), own.front(), own.back());
            }
        }
    }
    return std::nullopt;
}

/// Of a light, only what it sends has a sign.
inline std::span<const double> signedPart(const EvalCase& request, const Numbers& values) {
    return std::span(values).subspan(request.subject == EvalCase::Subject::Light ? 3 : 0);
}

template <class Judge>
Experiment ofHardCases(const Block& block, const Care& care, Judge judge) {
    auto hard = std::make_shared<HardCases>(block);
    return {care.edgeCaseTrials, [hard] { return std::vector{hard->next()}; },
            [judge](const auto& cases, const auto& values) {
                return judge(cases.front(), values.front());
            }};
}

inline std::shared_ptr<OrdinaryCases> ordinaryCases(const Block& block) {
    auto ordinary = std::make_shared<OrdinaryCases>(block);
    ordinary->leaveOptionalSlotsEmpty();
    return ordinary;
}

inline Experiment finite(const Block& block, const Care& care) {
    return ofHardCases(block, care, [](const EvalCase&, const Numbers& values) {
        return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
    });
}

inline Experiment nonNegative(const Block& block, const Care& care) {
    return ofHardCases(block, care, [](const EvalCase& request, const Numbers& values) {
        const auto part = signedPart(request, values);
        return std::all_of(part.begin(), part.end(), [](double x) { return x >= 0.0; });
    });
}

inline Experiment zeroBelowHorizon(const Block& block, const Care& care) {
    return ofHardCases(block, care, [](const EvalCase& request, const Numbers& values) {
        return (request.l.z > 0.0 && request.v.z > 0.0) || values[0] == 0.0;
    });
}

/// f(l, v) = f(v, l), with f = value / (n.l).
inline Experiment reciprocal(const Block& block, const Care& care) {
    auto ordinary = ordinaryCases(block);
    return {care.ordinaryTrials,
            [ordinary] {
                const EvalCase request = ordinary->next();
                EvalCase exchanged = request;
                std::swap(exchanged.l, exchanged.v);
                return std::vector{request, exchanged};
            },
            [care](const auto& cases, const auto& values) {
                const double there = values[0][0] / glm::normalize(cases[0].l).z;
                const double back = values[1][0] / glm::normalize(cases[0].v).z;
                return std::abs(there - back) <= care.rounding * (1.0 + there);
            }};
}

inline glm::dvec3 turned(const glm::dvec3& v, double angle) {
    return {v.x * std::cos(angle) - v.y * std::sin(angle),
            v.x * std::sin(angle) + v.y * std::cos(angle), v.z};
}

/// The value does not change when light and viewer are turned together about the normal.
inline Experiment isotropic(const Block& block, const Care& care) {
    auto ordinary = ordinaryCases(block);
    auto turn = std::make_shared<double>(0.7);
    return {care.ordinaryTrials,
            [ordinary, turn] {
                const EvalCase request = ordinary->next();
                EvalCase rotated = request;
                rotated.l = turned(request.l, *turn);
                rotated.v = turned(request.v, *turn);
                *turn += 1.0;
                return std::vector{request, rotated};
            },
            [care](const auto&, const auto& values) {
                return std::abs(values[0][0] - values[1][0]) <=
                       care.rounding * (1.0 + values[0][0]);
            }};
}

/// The same case with every colour at its largest.
inline EvalCase brightest(EvalCase request) {
    for (EvalBlock* block : {&request.block, &request.slot}) {
        for (auto& [id, value] : block->values) {
            if (block->block->parameter(id)->type == ParameterType::Color) {
                value = glm::dvec3(block->block->parameter(id)->max);
            }
        }
    }
    return request;
}

/// What finds lobes as sharp as sliders make them and what gathers at the horizon, within 1e-3.
inline constexpr HemisphereRuleSize albedoRule{3, 0.5};

/// The case for viewers all over the hemisphere.
inline std::vector<EvalCase> fromEverywhere(EvalCase request) {
    std::vector<EvalCase> cases;
    for (const WeightedDirection& to : hemisphereRule(request.l, albedoRule)) {
        request.v = to.v;
        cases.push_back(request);
    }
    return cases;
}

/// The directional albedo by the values of fromEverywhere().
inline double albedo(const std::vector<EvalCase>& cases, const std::vector<Numbers>& values) {
    const auto rule = hemisphereRule(cases.front().l, albedoRule);
    double sum = 0.0;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        sum += rule[i].weight * values[i][0];
    }
    return sum / glm::normalize(cases.front().l).z;
}

/// No more comes back than arrives: the albedo is at most 1, and so is a share.
inline Experiment energyConserving(const Block& block, const Care& care) {
    if (block.kind != "models" && block.kind != "specular") {
        return ofHardCases(block, care,
                           [](const EvalCase&, const Numbers& values) { return values[0] <= 1.0; });
    }
    auto ordinary = ordinaryCases(block);
    return {
        care.ordinaryTrials / 400,
        [ordinary] { return fromEverywhere(brightest(ordinary->next())); },
        [](const auto& cases, const auto& values) { return albedo(cases, values) <= 1.0 + 1e-3; }};
}

/// At 1e-7 rad above the horizon at most a thousandth of what the same light gives higher up.
inline Experiment continuousAtHorizon(const Block& block, const Care& care) {
    auto ordinary = ordinaryCases(block);
    auto turn = std::make_shared<double>(0.0);
    return {care.ordinaryTrials / 10,
            [ordinary, turn] {
                EvalCase request = brightest(ordinary->next());
                request.v = direction(60.0, 37.0 * *turn);
                request.l = {std::cos(*turn), std::sin(*turn), 1e-7};
                std::vector<EvalCase> cases{request};
                for (const double degrees : {0.0, 20.0, 40.0, 60.0, 80.0}) {
                    request.l = direction(degrees, 37.0 * *turn + 180.0);
                    cases.push_back(request);
                }
                *turn += 1.0;
                return cases;
            },
            [](const auto&, const auto& values) {
                double largest = 0.0;
                for (std::size_t i = 1; i < values.size(); ++i) {
                    largest = std::max(largest, values[i][0]);
                }
                return values[0][0] <= 1e-3 * largest + 1e-12;
            }};
}

/// Of a Fresnel block: what is reflected does not fall as light gets flatter.
inline Experiment monotonic(const Block& block, const Care& care) {
    auto hard = std::make_shared<HardCases>(block);
    return {care.edgeCaseTrials / 100,
            [hard] {
                std::vector<EvalCase> cases(101, hard->next());
                for (std::size_t i = 0; i < cases.size(); ++i) {
                    cases[i].number = 1.0 - 0.01 * static_cast<double>(i);
                }
                return cases;
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
