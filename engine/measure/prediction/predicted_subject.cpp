// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_subject.h"

#include <utility>

#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

namespace patina {

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

Checked<std::vector<ProgramText>> surfaceTexts(const PredictedSubject& subject,
                                               const std::vector<Scene>& scenes) {
    std::vector<ProgramText> texts;
    for (const Scene& scene : scenes) {
        auto text = surfaceText({scene, subject.object, subject.meshes, subject.catalog});
        if (!text) {
            return tl::unexpected(text.error());
        }
        texts.push_back(std::move(*text));
    }
    return texts;
}

Checked<CompiledForFamilies> compiledScenes(const PredictedSubject& subject,
                                            const std::vector<Scene>& scenes,
                                            std::span<const GpuFamily* const> families,
                                            const FamilyCompilerOptions& options) {
    auto texts = surfaceTexts(subject, scenes);
    if (!texts) {
        return tl::unexpected(texts.error());
    }
    return compileForFamilies(families, std::move(*texts), options).map_error(oneError);
}

} // namespace patina
