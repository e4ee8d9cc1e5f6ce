// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_subject.h"

#include <algorithm>
#include <cmath>
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

/// Is a shader whose model has loops that vary: with one round of each, and then with two of each.
struct CountedSurface {
    std::size_t program = 0; ///< is its place among all
    std::size_t first = 0;   ///< is the place of its texts among all of these
    std::vector<VaryingLoop> loops{};
    std::vector<ProgramText> texts{};
};

CountedSurface countedSurface(const SurfaceText& surface, const Catalog& catalog) {
    CountedSurface made;
    made.loops = varyingLoops(surface.material, catalog);
    for (std::size_t twice = 0; twice <= made.loops.size() && !made.loops.empty(); ++twice) {
        std::vector<int> rounds(made.loops.size(), 1);
        if (twice > 0) {
            rounds[twice - 1] = 2;
        }
        auto fragment = withRounds(surface.text.fragment, made.loops, rounds);
        if (!fragment) {
            return {};
        }
        made.texts.push_back({surface.text.vertex, std::move(*fragment)});
    }
    return made;
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
        const StageStatistics& once = texts.front()->at(family).fragment;
        stage.cycles = once.cycles;
        stage.latency = once.latency;
        stage.loops = once.loops;
        for (std::size_t i = 0; i < surface.loops.size(); ++i) {
            const StageStatistics& twice = texts[i + 1]->at(family).fragment;
            stage.cycles += (surface.loops[i].rounds - 1.0) * (twice.cycles - once.cycles);
            stage.latency += (surface.loops[i].rounds - 1.0) * (twice.latency - once.latency);
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

Checked<std::vector<SurfaceText>> surfaceTexts(const PredictedSubject& subject,
                                               const std::vector<Scene>& scenes) {
    std::vector<SurfaceText> texts;
    for (const Scene& scene : scenes) {
        auto text = surfaceText({scene, subject.object, subject.meshes, subject.catalog});
        if (!text) {
            return tl::unexpected(text.error());
        }
        texts.push_back({std::move(*text), scene.objects[subject.object].material});
    }
    return texts;
}

Result<CompiledForFamilies> compiledSurfaces(const std::vector<SurfaceText>& surfaces,
                                             const Catalog& catalog,
                                             std::span<const GpuFamily* const> families,
                                             const FamilyCompilerOptions& options) {
    std::vector<ProgramText> texts;
    for (const SurfaceText& surface : surfaces) {
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
