// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/trial_scene.h"

#include <algorithm>

#include "material/block_values.h"
#include "shading/effects/block_trial.h"

namespace patina {

Scene trialScene(const Block& block, const Catalog& catalog) {
    Scene scene;
    Object object;
    object.material = trialMaterial(block, catalog);
    object.material.opacity =
        block.kind == kinds::transparency || block.kind == kinds::refraction ? 0.5 : 1.0;
    scene.objects.push_back(object);
    object.translation = {0.7, 0.7, -0.7}; // behind it, and in its shadow
    scene.objects.push_back(object);
    if (const Block* light = trialLight(block, catalog)) {
        scene.lights.push_back({"light", true, defaultBlockValues(*light)});
        if (std::ranges::count(partKinds(BlockOwner::Light), block.kind) > 0) {
            scene.lights.back().setPart(block.kind, defaultBlockValues(block));
        }
    }
    if (std::ranges::count(partKinds(BlockOwner::Scene), block.kind) > 0) {
        scene.setPart(block.kind, defaultBlockValues(block));
    }
    scene.ambient = glm::dvec3(0.25);
    return scene;
}

} // namespace patina
