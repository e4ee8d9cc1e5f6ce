// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_models.h"

#include <utility>

namespace patina {

Checked<PredictedModels> predictedModels(const PredictedSubject& subject,
                                         std::span<const GpuFamily* const> families,
                                         const FamilyCompilerOptions& options) {
    const std::vector<const Block*> models = subject.catalog->ofKind(kinds::models);
    std::vector<Scene> scenes(models.size(), subject.scene);
    for (std::size_t i = 0; i < models.size(); ++i) {
        scenes[i].objects[subject.object].material = defaultMaterial(*models[i]);
    }
    auto compiled = compiledScenes(subject, scenes, families, options);
    if (!compiled) {
        return tl::unexpected(compiled.error());
    }
    PredictedModels predicted{std::move(compiled->driver), {}};
    for (std::size_t i = 0; i < models.size(); ++i) {
        predicted.models.push_back(
            {models[i]->id, models[i]->label, std::move(compiled->programs[i])});
    }
    return predicted;
}

} // namespace patina
