// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/refraction_effects.h"

#include <fmt/format.h>

#include "shading/effects/block_use.h"
#include "shading/effects/refraction_choice.h"

namespace patina {
namespace {

const char* whatIsBehind(const SceneEffects& scene) {
    if (scene.isShownRefracted) {
        return scene.environment ? "the scene and the environment" : "the scene";
    }
    return scene.environment ? "the environment" : "the background's colour";
}

} // namespace

void addRefraction(EffectSet& set, const Material& material, const Scene& scene,
                   const Catalog& catalog) {
    const RefractionChoice choice = refractionChoice(material, catalog);
    if (choice.block == nullptr) {
        if (const BlockValues* part = material.part(kinds::refraction)) {
            set.leftOut.push_back({"refraction/" + part->id, choice.whyNot});
        }
        return;
    }
    const char* order = scene.part(kinds::transparency)
                            ? " Such objects are sorted, and hide what else lets light through."
                            : "";
    set.refraction =
        useOf(*choice.block, *choice.values, material.accuracy,
              fmt::format("What passes is bent by an index of {:.4g} and shows {}.{}",
                          bodyIndex(material, choice, catalog), whatIsBehind(set.scene), order));
}

} // namespace patina
