// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/trial_scene.h"

#include "material/block_values.h"
#include "shading/program/block_trial.h"

namespace patina {

Scene trialScene(const Block& block, const Catalog& catalog) {
    Scene scene;
    Object object;
    object.material = trialMaterial(block, catalog);
    object.material.opacity =
        block.kind == "transparency" || block.kind == "refraction" ? 0.5 : 1.0;
    scene.objects.push_back(object);
    object.translation = {0.7, 0.7, -0.7}; // behind it, and in its shadow
    scene.objects.push_back(object);
    if (const Block* light = trialLight(block, catalog)) {
        scene.lights.push_back({"light", true, defaultBlockValues(*light)});
        if (block.kind == "shadows") {
            scene.lights.back().shadow = defaultBlockValues(block);
        }
    }
    if (block.kind == "fog") {
        scene.fog = defaultBlockValues(block);
    } else if (block.kind == "environment") {
        scene.environment = defaultBlockValues(block);
    } else if (block.kind == "transparency") {
        scene.transparency = defaultBlockValues(block);
    }
    scene.ambient = glm::dvec3(0.25);
    return scene;
}

} // namespace patina
