// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_effects.h"

#include <algorithm>
#include <utility>

namespace patina {
namespace {

/// Returns the fragment stages with and without an effect; nothing where one is missing.
std::optional<std::pair<StageStatistics, StageStatistics>>
stagesOf(const PredictedEffects& predicted, std::string_view effect, const std::string& family) {
    const auto found = std::ranges::find(predicted.effects, effect, &PredictedEffect::effect);
    if (found == predicted.effects.end() || !predicted.whole || !found->without ||
        !predicted.whole->contains(family) || !found->without->contains(family)) {
        return std::nullopt;
    }
    return std::pair(predicted.whole->at(family).fragment, found->without->at(family).fragment);
}

} // namespace

Checked<PredictedEffects> predictedEffects(const PredictedSubject& subject,
                                           std::span<const EffectRow> rows,
                                           std::span<const GpuFamily* const> families,
                                           const FamilyCompilerOptions& options) {
    std::vector<std::string> effects;
    std::vector<Scene> scenes{subject.scene};
    for (const EffectRow& row : rows) {
        if (row.in && row.removable) {
            effects.push_back(row.line.effect);
            scenes.push_back(withoutEffects(subject.scene, {&effects.back(), 1}, *subject.catalog));
        }
    }
    auto compiled = compiledScenes(subject, scenes, families, options);
    if (!compiled) {
        return tl::unexpected(compiled.error());
    }
    PredictedEffects predicted{
        std::move(compiled->driver), std::move(compiled->programs.front()), {}};
    for (std::size_t i = 0; i < effects.size(); ++i) {
        predicted.effects.push_back({std::move(effects[i]), std::move(compiled->programs[i + 1])});
    }
    return predicted;
}

std::optional<double> PredictedEffects::cyclesOf(std::string_view effect,
                                                 const std::string& family) const {
    const auto stages = stagesOf(*this, effect, family);
    return stages ? std::optional(stages->first.cycles - stages->second.cycles) : std::nullopt;
}

std::optional<int> PredictedEffects::instructionsOf(std::string_view effect,
                                                    const std::string& family) const {
    const auto stages = stagesOf(*this, effect, family);
    return stages ? std::optional(stages->first.instructions - stages->second.instructions)
                  : std::nullopt;
}

const Error* PredictedEffects::problemOf(std::string_view effect) const {
    const auto found = std::ranges::find(effects, effect, &PredictedEffect::effect);
    return found == effects.end() || found->without ? nullptr : &found->without.error();
}

} // namespace patina
