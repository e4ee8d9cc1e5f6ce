// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_subject.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "measure/prediction/varying_loops.h"
#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

namespace patina {
namespace {

/// Tells whether the compiler guesses how often loops run.
bool hasLoops(const Result<FamilyStatistics>& program) {
    return program && std::ranges::any_of(*program, [](const auto& family) {
               return family.second.fragment.loops > 0;
           });
}

/// Is a shader whose model has loops that vary: with two rounds of each, and then with three of
/// each.
struct CountedSurface {
    std::size_t program = 0;      ///< is its place among all
    std::size_t first = 0;        ///< is the place of its texts among all of these
    std::vector<double> rounds{}; ///< are those of the loops that vary
    std::vector<ProgramText> texts{};
};

constexpr int fewRounds = 2; ///< as one may be computed in the place of what leads to it

CountedSurface countedSurface(const PredictedSurface& surface, const Catalog& catalog) {
    CountedSurface made;
    const std::vector<VaryingLoop> loops = varyingLoops(surface.material, catalog);
    std::vector<int> few;
    for (const VaryingLoop& loop : loops) {
        few.push_back(loop.isVarying ? fewRounds : static_cast<int>(loop.rounds));
    }
    const auto add = [&](const std::vector<int>& rounds) {
        auto fragment = withRounds(surface.text.fragment, loops, rounds);
        if (fragment) {
            made.texts.push_back({surface.text.vertex, std::move(*fragment)});
        }
        return fragment.has_value();
    };
    bool isWhole = !loops.empty() && add(few);
    for (std::size_t i = 0; i < loops.size() && isWhole; ++i) {
        if (loops[i].isVarying) {
            std::vector<int> rounds = few;
            ++rounds[i];
            made.rounds.push_back(loops[i].rounds);
            isWhole = add(rounds);
        }
    }
    return isWhole ? std::move(made) : CountedSurface();
}

void correct(Result<FamilyStatistics>& program, const CountedSurface& surface,
             std::span<const Result<FamilyStatistics>> texts) {
    if (texts.empty() || !std::ranges::all_of(texts, [](const auto& text) { return !!text; })) {
        return;
    }
    // A loop around it that is unrolled in one of them alone is guessed in the others, so that they
    // do not tell what a round takes.
    for (const auto& text : texts) {
        for (const auto& [family, statistics] : *text) {
            if (statistics.fragment.loops != texts.front()->at(family).fragment.loops) {
                return;
            }
        }
    }
    for (auto& [family, statistics] : *program) {
        StageStatistics& stage = statistics.fragment;
        const StageStatistics& few = texts.front()->at(family).fragment;
        stage.cycles = few.cycles;
        stage.latency = few.latency;
        stage.loops = few.loops;
        stage.countedRounds = std::accumulate(surface.rounds.begin(), surface.rounds.end(), 0.0);
        for (std::size_t i = 0; i < surface.rounds.size(); ++i) {
            const StageStatistics& more = texts[i + 1]->at(family).fragment;
            const double others = surface.rounds[i] - fewRounds;
            stage.cycles += others * (more.cycles - few.cycles);
            stage.latency += others * (more.latency - few.latency);
        }
        stage.cycles = std::round(stage.cycles);
        stage.latency = std::round(stage.latency);
    }
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

Checked<std::vector<PredictedSurface>> surfaceTexts(const PredictedSubject& subject,
                                                    const std::vector<Scene>& scenes) {
    std::vector<PredictedSurface> texts;
    for (const Scene& scene : scenes) {
        auto text = surfaceText({scene, subject.object, subject.meshes, subject.catalog});
        if (!text) {
            return tl::unexpected(text.error());
        }
        texts.push_back({std::move(*text), scene.objects[subject.object].material});
    }
    return texts;
}

Result<CompiledForFamilies> compiledSurfaces(const std::vector<PredictedSurface>& surfaces,
                                             const Catalog& catalog,
                                             std::span<const GpuFamily* const> families,
                                             const FamilyCompilerOptions& options) {
    std::vector<ProgramText> texts;
    for (const PredictedSurface& surface : surfaces) {
        texts.push_back(surface.text);
    }
    auto compiled = compileForFamilies(families, std::move(texts), options);
    if (!compiled) {
        return compiled;
    }
    std::vector<CountedSurface> counted;
    std::vector<ProgramText> more;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        if (hasLoops(compiled->programs[i])) {
            CountedSurface made = countedSurface(surfaces[i], catalog);
            made.program = i;
            made.first = more.size();
            more.insert(more.end(), made.texts.begin(), made.texts.end());
            counted.push_back(std::move(made));
        }
    }
    if (more.empty()) {
        return compiled;
    }
    const auto rounds = compileForFamilies(families, std::move(more), options);
    if (!rounds) {
        return tl::unexpected(rounds.error());
    }
    for (const CountedSurface& each : counted) {
        correct(compiled->programs[each.program], each,
                std::span(rounds->programs).subspan(each.first, each.texts.size()));
    }
    return compiled;
}

Checked<CompiledForFamilies> compiledScenes(const PredictedSubject& subject,
                                            const std::vector<Scene>& scenes,
                                            std::span<const GpuFamily* const> families,
                                            const FamilyCompilerOptions& options) {
    const auto texts = surfaceTexts(subject, scenes);
    if (!texts) {
        return tl::unexpected(texts.error());
    }
    return compiledSurfaces(*texts, *subject.catalog, families, options).map_error(oneError);
}

} // namespace patina
