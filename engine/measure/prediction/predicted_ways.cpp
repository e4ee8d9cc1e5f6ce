// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_ways.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace patina {
namespace {

/// Returns the levels to compile: none, each alone, those that the material has.
std::vector<ChosenLevels> eachLevel(const std::vector<Choice>& choices,
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

/// Returns the scene of the subject with levels of its material's choices.
Scene sceneWith(const PredictedSubject& subject, const std::vector<Choice>& choices,
                const ChosenLevels& levels) {
    ChosenFrame frame{subject.scene, {}};
    choose(frame, subject.object, choices, levels, *subject.catalog);
    return std::move(frame.scene);
}

/// Holds the levels of a subject's ways, and the scene of each.
struct Ways {
    std::vector<ChosenLevels> levels;
    std::vector<Scene> scenes;
};

Ways waysOf(const PredictedSubject& subject, PredictedLevels levels) {
    const Scene& scene = subject.scene;
    const std::vector<Choice> choices = materialChoices(scene, subject.object, *subject.catalog);
    const ChosenLevels present = levelsOf(scene.objects[subject.object].material, choices);
    Ways ways;
    ways.levels = levels == PredictedLevels::Each ? eachLevel(choices, present)
                                                  : std::vector<ChosenLevels>{present};
    for (const ChosenLevels& each : ways.levels) {
        ways.scenes.push_back(sceneWith(subject, choices, each));
    }
    return ways;
}

} // namespace

const PredictedWay* PredictedPoints::find(const ChosenLevels& levels) const {
    const auto found = std::ranges::find(ways, levels, &PredictedWay::levels);
    return found == ways.end() ? nullptr : &*found;
}

Checked<PredictedPoints> predictedPoints(const PredictedSubject& subject,
                                         std::span<const ChosenLevels> ways,
                                         std::span<const GpuFamily* const> families,
                                         const FamilyCompilerOptions& options) {
    const std::vector<Choice> choices =
        materialChoices(subject.scene, subject.object, *subject.catalog);
    std::vector<Scene> scenes;
    for (const ChosenLevels& levels : ways) {
        scenes.push_back(sceneWith(subject, choices, levels));
    }
    auto compiled = compiledScenes(subject, scenes, families, options);
    if (!compiled) {
        return tl::unexpected(compiled.error());
    }
    PredictedPoints predicted{std::move(compiled->driver), {}};
    for (std::size_t i = 0; i < ways.size(); ++i) {
        predicted.ways.push_back({ways[i], std::move(compiled->programs[i])});
    }
    return predicted;
}

Checked<PredictedWays> predictedWays(std::span<const PredictedSubject> subjects,
                                     PredictedLevels wanted,
                                     std::span<const GpuFamily* const> families,
                                     const FamilyCompilerOptions& options) {
    std::vector<std::vector<ChosenLevels>> levels;
    std::vector<PredictedSurface> texts;
    for (const PredictedSubject& subject : subjects) {
        Ways ways = waysOf(subject, wanted);
        auto more = surfaceTexts(subject, ways.scenes);
        if (!more) {
            return tl::unexpected(more.error());
        }
        std::ranges::move(*more, std::back_inserter(texts));
        levels.push_back(std::move(ways.levels));
    }
    if (subjects.empty()) {
        return PredictedWays();
    }
    auto compiled = compiledSurfaces(texts, *subjects.front().catalog, families, options);
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

} // namespace patina
