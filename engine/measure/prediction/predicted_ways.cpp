// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_ways.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

namespace patina {
namespace {

/// Returns the levels to compile: none, each alone, those that the material has.
std::vector<ChosenLevels> levelsToCompile(const std::vector<Choice>& choices,
                                          const ChosenLevels& present) {
    std::vector<ChosenLevels> all{{}};
    for (const Choice& choice : choices) {
        for (std::size_t i = 1; i < choice.levels.size(); ++i) {
            all.push_back({{choice.id, choice.levels[i].id}});
        }
    }
    if (std::ranges::find(all, present) == all.end()) {
        all.push_back(present);
    }
    return all;
}

/// Returns the text of the subject's object in each of these scenes.
Checked<std::vector<ProgramText>> textsIn(std::vector<Scene> scenes,
                                          const PredictedSubject& subject) {
    std::vector<ProgramText> texts;
    for (Scene& scene : scenes) {
        auto text =
            surfaceText({std::move(scene), subject.object, subject.meshes, subject.catalog});
        if (!text) {
            return tl::unexpected(text.error());
        }
        texts.push_back(std::move(*text));
    }
    return texts;
}

/// Holds the levels of a subject's ways, and the scene of each.
struct Ways {
    std::vector<ChosenLevels> levels;
    std::vector<Scene> scenes;
};

Ways waysOf(const PredictedSubject& subject) {
    const Scene& scene = subject.scene;
    const std::vector<Choice> choices = materialChoices(scene, subject.object, *subject.catalog);
    Ways ways{levelsToCompile(choices, levelsOf(scene.objects[subject.object].material, choices)),
              {}};
    for (const ChosenLevels& each : ways.levels) {
        ChosenFrame frame{scene, {}};
        choose(frame, subject.object, choices, each, *subject.catalog);
        ways.scenes.push_back(std::move(frame.scene));
    }
    return ways;
}

} // namespace

Checked<ProgramText> surfaceText(const PredictedSubject& subject) {
    const auto& [scene, object, meshes, catalog] = subject;
    const EffectSet effects = effectSet(scene.objects[object].material, scene, *catalog,
                                        objectView(scene, object, *catalog, meshes));
    auto source = surfaceProgram(effects, *catalog);
    if (!source) {
        return tl::unexpected(source.error());
    }
    return ProgramText{std::move(source->vertex.text), std::move(source->fragment.text)};
}

Checked<PredictedWays> predictedWays(std::span<const PredictedSubject> subjects,
                                     std::span<const GpuFamily* const> families,
                                     const FamilyCompilerOptions& options) {
    std::vector<std::vector<ChosenLevels>> levels;
    std::vector<ProgramText> texts;
    for (const PredictedSubject& subject : subjects) {
        Ways ways = waysOf(subject);
        auto more = textsIn(std::move(ways.scenes), subject);
        if (!more) {
            return tl::unexpected(more.error());
        }
        std::ranges::move(*more, std::back_inserter(texts));
        levels.push_back(std::move(ways.levels));
    }
    auto compiled = compileForFamilies(families, std::move(texts), options);
    if (!compiled) {
        return tl::unexpected(oneError(compiled.error()));
    }
    PredictedWays predicted{std::move(compiled->driver), {}};
    auto program = compiled->programs.begin();
    for (std::vector<ChosenLevels>& ofOne : levels) {
        predicted.subjects.emplace_back();
        for (ChosenLevels& each : ofOne) {
            predicted.subjects.back().push_back({std::move(each), std::move(*program++)});
        }
    }
    return predicted;
}

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
    auto texts = textsIn(std::move(scenes), subject);
    if (!texts) {
        return tl::unexpected(texts.error());
    }
    auto compiled = compileForFamilies(families, std::move(*texts), options);
    if (!compiled) {
        return tl::unexpected(oneError(compiled.error()));
    }
    PredictedEffects predicted{
        std::move(compiled->driver), std::move(compiled->programs.front()), {}};
    for (std::size_t i = 0; i < effects.size(); ++i) {
        predicted.effects.push_back({std::move(effects[i]), std::move(compiled->programs[i + 1])});
    }
    return predicted;
}

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

} // namespace patina
