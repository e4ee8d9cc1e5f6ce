// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/claim_trials.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "measure/stability/edge_case_directions.h"
#include "measure/stability/hemisphere_rule.h"

namespace patina {
namespace {

using Broken = ClaimTrial::Broken;
using Verdict = std::optional<Broken>;
using Trials = std::vector<ClaimTrial>;

/// Is the tolerance between two values of the shader, each of which is right to 1e-4.
constexpr double deviceRounding = 2e-4;

/// Is what the rule's error and the shader's rounding may add to an albedo of 1.
constexpr double albedoSlack = 5e-3;
constexpr HemisphereRuleSize albedoRule{2, 0.5};

constexpr double lightDegrees[] = {0.0, 30.0, 50.0, 70.0, 80.0, 87.0};
constexpr std::size_t pairs = 256;

/// Is the cosine of light that may be reflected with at most horizonShare of the largest value of
/// light higher up.
constexpr double grazing = 1e-7;
constexpr double horizonShare = 1e-3;

glm::dvec3 inSinglePrecision(const glm::dvec3& v) {
    return glm::dvec3(glm::vec3(v));
}

glm::dvec3 directionAt(double degrees, double azimuth) {
    const double theta = degrees * std::numbers::pi / 180.0;
    return inSinglePrecision({std::sin(theta) * std::cos(azimuth),
                              std::sin(theta) * std::sin(azimuth), std::cos(theta)});
}

EvalPlace placed(const glm::dvec3& l, const glm::dvec3& v) {
    EvalPlace place;
    place.l = inSinglePrecision(l);
    place.v = inSinglePrecision(v);
    return place;
}

/// Refutes a claim where `value` differs from `wanted` by more than the tolerance, which is
/// relative to 1 + |wanted|.
Verdict unequal(double value, double wanted) {
    const double excess = std::abs(value - wanted) / (deviceRounding * (1.0 + std::abs(wanted)));
    return excess <= 1.0 ? Verdict() : Broken{0, value, wanted, excess};
}

/// Adds trials of a place and of the same after `change`; where `perLight` is set, the values are
/// divided by n.l.
template <class Change>
void addPairs(Trials& trials, Defect defect, bool perLight, Change change) {
    double turn = 0.7;
    for (const EvalPlace& place : ordinaryPlaces(EvalCase::Subject::Model, pairs)) {
        ClaimTrial& trial = trials.emplace_back();
        trial.defect = defect;
        trial.places = {place, change(place, turn)};
        const double first = perLight ? glm::normalize(place.l).z : 1.0;
        const double second = perLight ? glm::normalize(trial.places[1].l).z : 1.0;
        trial.judge = [first, second](std::span<const double> values) {
            return unequal(values[0] / first, values[1] / second);
        };
        turn += 1.0;
    }
}

EvalPlace exchanged(const EvalPlace& place, double) {
    return placed(place.v, place.l);
}

EvalPlace turned(const EvalPlace& place, double angle) {
    const auto about = [angle](const glm::dvec3& v) {
        return glm::dvec3(v.x * std::cos(angle) - v.y * std::sin(angle),
                          v.x * std::sin(angle) + v.y * std::cos(angle), v.z);
    };
    return placed(about(place.l), about(place.v));
}

void addAlbedos(Trials& trials) {
    for (const double degrees : lightDegrees) {
        ClaimTrial& trial = trials.emplace_back();
        trial.defect = Defect::NotConserving;
        trial.brightest = true;
        const glm::dvec3 l = directionAt(degrees, degrees);
        std::vector<double> weights;
        for (const WeightedDirection& to : hemisphereRule(l, albedoRule)) {
            trial.places.push_back(placed(l, to.v));
            weights.push_back(to.weight / l.z);
        }
        trial.judge = [weights](std::span<const double> values) {
            double albedo = 0.0;
            for (std::size_t i = 0; i < values.size(); ++i) {
                albedo += weights[i] * std::max(values[i], 0.0);
            }
            const double excess = (albedo - 1.0) / albedoSlack;
            return excess <= 1.0 ? Verdict() : Broken{0, albedo, 1.0, excess};
        };
    }
}

void addHorizons(Trials& trials) {
    for (double turn = 0.0; turn < 16.0; turn += 1.0) {
        ClaimTrial& trial = trials.emplace_back();
        trial.defect = Defect::NotContinuous;
        trial.brightest = true;
        const glm::dvec3 v = directionAt(60.0, 0.6 * turn);
        trial.places.push_back(placed({std::cos(turn), std::sin(turn), grazing}, v));
        for (const double degrees : {0.0, 20.0, 40.0, 60.0, 80.0}) {
            trial.places.push_back(placed(directionAt(degrees, 0.6 * turn + std::numbers::pi), v));
        }
        trial.judge = [](std::span<const double> values) {
            const double largest = *std::max_element(values.begin() + 1, values.end());
            const double limit = horizonShare * largest + 1e-12;
            return values[0] <= limit ? Verdict() : Broken{0, values[0], limit, values[0] / limit};
        };
    }
}

Trials modelTrials(const EvalCase& variant) {
    const Block& model = *variant.block.block;
    Trials trials;
    if (model.hasClaim("reciprocal")) {
        addPairs(trials, Defect::NotReciprocal, true, exchanged);
    }
    if (model.hasClaim("isotropic")) {
        addPairs(trials, Defect::NotIsotropic, false, turned);
    }
    if (model.hasClaim("energy_conserving")) {
        addAlbedos(trials);
    }
    if (model.hasClaim("continuous_at_horizon")) {
        addHorizons(trials);
    }
    return trials;
}

/// Returns trials of a Fresnel block in steps of 0.01 of the cosine.
Trials fresnelTrials(const Block& block) {
    constexpr double step = 1e-6;
    std::vector<EvalPlace> places(101);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto cosine = static_cast<float>(1.0 - 0.01 * static_cast<double>(i));
        places[i].number = static_cast<double>(cosine);
    }
    Trials trials;
    if (block.hasClaim("energy_conserving")) {
        trials.push_back({Defect::NotConserving, false, places, [](std::span<const double> values) {
                              const auto largest = std::max_element(values.begin(), values.end());
                              const auto at = std::size_t(largest - values.begin());
                              return *largest <= 1.0 + step
                                         ? Verdict()
                                         : Broken{at, *largest, 1.0, (*largest - 1.0) / step};
                          }});
    }
    if (block.hasClaim("monotonic")) {
        trials.push_back(
            {Defect::NotMonotonic, false, places, [](std::span<const double> values) {
                 for (std::size_t i = 1; i < values.size(); ++i) {
                     const double fall = values[i - 1] - values[i];
                     if (fall > step) {
                         return Verdict(Broken{i, values[i], values[i - 1], fall / step});
                     }
                 }
                 return Verdict();
             }});
    }
    return trials;
}

} // namespace

Trials claimTrials(const EvalCase& variant) {
    if (variant.subject == EvalCase::Subject::Fresnel) {
        return fresnelTrials(*variant.block.block);
    }
    const auto& slots = variant.block.block->slots;
    const bool filled = variant.slot.block != nullptr;
    const bool optional = !slots.empty() && slots.front().defaultBlock.empty();
    const bool tried = variant.subject == EvalCase::Subject::Model && !(filled && optional);
    return tried ? modelTrials(variant) : Trials();
}

EvalCase brightest(EvalCase request) {
    for (EvalBlock* block : {&request.block, &request.slot}) {
        for (auto& [id, value] : block->values) {
            if (infoOf(block->block->parameter(id)->type).isColor) {
                value = glm::dvec3(block->block->parameter(id)->max);
            }
        }
    }
    return request;
}

} // namespace patina
