// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that makes programs before a frame needs them.
#include <algorithm>

#include <boost/container_hash/hash.hpp>
#include <epoxy/gl.h>

#include "render/frame/frame_drawer.h"
#include "shading/effects/material_hash.h"
#include "shading/effects/refraction.h"

namespace patina {

bool FrameDrawer::hasPipelines(const Scene& effects) {
    const std::uint64_t sceneKey = keys_.ofScene(effects, *catalog_);
    if (!display_.has(effects)) {
        return false;
    }
    if (isSeen(effects.ground) && !pipelines_.hasGround(effects.ground.mode, sceneKey)) {
        return false;
    }
    std::size_t known = 0;
    materialKeys_.clear(effects.objects.size());
    return std::all_of(effects.objects.begin(), effects.objects.end(), [&](const Object& object) {
        if (!object.visible || materialKeys_.find(materialHash(object.material), known) < known) {
            return true;
        }
        ++known;
        return pipelines_.has(EffectKey::ofMaterial(object.material, *catalog_), sceneKey);
    });
}

std::uint64_t FrameDrawer::missingPrograms(const Scene& scene, const View& view,
                                           const MeshSource& meshes) {
    if (catalog_ == nullptr) {
        return 0;
    }
    effects_ = &effectsOf(view, scene);
    heldEffects_ = effects_ != &scene;
    collect(scene, view, meshes, Purpose::Frame);
    planGround(scene, view);
    beginSurroundings();
    std::size_t missing = display_.has(*effects_) ? 0 : 1;
    for (const DrawMaterial& material : materials_) {
        const std::uint64_t key =
            EffectKey::ofMaterial(effects_->objects[material.object].material, *catalog_);
        const std::uint64_t around = surroundings(material.missing).key;
        if (!pipelines_.has(key, around)) {
            boost::hash_combine(missing, key);
            boost::hash_combine(missing, around);
        }
    }
    if (ground_.isSeen) {
        const std::uint64_t around = surroundings(missingKinds(ground_.lights)).key;
        if (!pipelines_.hasGround(effects_->ground.mode, around)) {
            boost::hash_combine(missing, 1);
            boost::hash_combine(missing, around);
        }
    }
    effects_ = nullptr;
    return missing;
}

void FrameDrawer::makeTargets(const Scene& scene, const View& view, const MeshSource& meshes) {
    if (catalog_ == nullptr) {
        return;
    }
    effects_ = &effectsOf(view, scene);
    heldEffects_ = effects_ != &scene;
    collect(scene, view, meshes, Purpose::Frame);
    count();
    // What does not fit is told by the frame itself.
    static_cast<void>(fitTarget(scene.accuracy, view, showsSceneRefracted(*effects_, *catalog_)));
    effects_ = nullptr;
}

/// The programs of the picture, and those of a drag, in which places and distances decide nothing.
bool FrameDrawer::prewarm(const Scene& scene, const View& view, const MeshSource& meshes) {
    if (catalog_ == nullptr) {
        return false;
    }
    bool isMade = false;
    if (missingPrograms(scene, view, meshes) != 0) {
        drawUnseen(scene, view, meshes);
        isMade = true;
    }
    if (!hasPipelines(effectsOf(view, scene))) {
        prewarmsHeld_ = true;
        drawUnseen(scene, view, meshes);
        prewarmsHeld_ = false;
        isMade = true;
    }
    return isMade;
}

/// Drivers put work off until a program is drawn with: it is, outside of what can be seen. Where
/// there are very many triangles that would take longer than it saves.
void FrameDrawer::drawUnseen(const Scene& scene, const View& view, const MeshSource& meshes) {
    FrameReport before = report_;
    if (begin(scene, view, meshes, Purpose::Prewarming) && !isLarge() && uploadMeshes(never)) {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 0, 0);
        isUnseen_ = true;
        drawItems(scene, never);
        isUnseen_ = false;
        environment_.addUnseen(target_.resolved(), *catalog_, pipelines_.programs());
        glDisable(GL_SCISSOR_TEST);
        leaveState();
    }
    effects_ = nullptr;
    report_ = std::move(before);
}

} // namespace patina
