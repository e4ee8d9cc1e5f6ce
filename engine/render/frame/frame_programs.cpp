// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that chooses the programs.
#include <algorithm>

#include "render/frame/frame_drawer.h"

namespace patina {

/// Those of all objects and the ground, unless one had to be made: the next call goes on then.
void FrameDrawer::choosePipelines() {
    const int built = pipelines_.programs().builtCount();
    beginSurroundings();
    sources_.clear();
    if (lastGood_.size() < effects_->objects.size()) {
        lastGood_.resize(effects_->objects.size());
    }
    for (DrawMaterial& material : materials_) {
        choosePipeline(material);
        if (pipelines_.programs().builtCount() > built) {
            return;
        }
    }
    for (const DrawItem& item : items_) {
        const std::shared_ptr<const Pipeline>& chosen = materials_[item.material].pipeline;
        if (lastGood_[item.index] != chosen) {
            lastGood_[item.index] = chosen;
        }
    }
    chooseGround();
}

/// While a value is dragged neither depth nor place decides anything.
void FrameDrawer::beginSurroundings() {
    sceneKeys_.clear();
    effectView_ = heldEffects_ ? EffectView() : effectView(depths_, fogReach());
}

/// Whether the frame's objects and its ground lie behind the fog's box or in it.
FogReach FrameDrawer::fogReach() const {
    FogReach fog(*effects_, *catalog_, glm::dvec3(cameras_.cameraToWorld[3]));
    if (!fog.asks()) {
        return fog;
    }
    for (const DrawItem& item : items_) {
        fog.add(item.placement->corners);
    }
    if (ground_.isSeen) {
        fog.add(groundBounds(), worldMatrix(ground_.place));
    }
    return fog;
}

/// What is around objects with this lack of lights.
PipelineStore::Surroundings FrameDrawer::surroundings(std::size_t missing) {
    EffectView view = effectView_;
    view.unreached = lightKinds_.lights(missing);
    auto known =
        std::ranges::find(sceneKeys_, missing, &std::pair<std::size_t, std::uint64_t>::first);
    if (known == sceneKeys_.end()) {
        known = sceneKeys_.insert(known, {missing, keys_.ofScene(*effects_, *catalog_, view)});
    }
    return {*effects_, known->second, view};
}

/// A program that does not compile leaves the objects with the last good one.
void FrameDrawer::choosePipeline(DrawMaterial& material) {
    const PipelineStore::Surroundings around = surroundings(material.missing);
    const Material& effects = effects_->objects[material.object].material;
    const std::uint64_t key = EffectKey::ofMaterial(effects, *catalog_);
    const PipelineStore::Entry& entry = pipelines_.get(effects, key, around);
    material.pipeline = entry.pipeline ? entry.pipeline : lastGood_[material.object];
    if (!entry.pipeline) {
        noteSource(&entry);
    }
    if (!material.pipeline) {
        const PipelineStore::Entry& fallback = pipelines_.fallback(around);
        material.pipeline = fallback.pipeline;
        if (!fallback.pipeline) {
            noteSource(&fallback);
        }
    }
    if (material.pipeline) {
        noteSource(material.pipeline.get());
    }
}

/// What is drawn with one call, and where its data lie.
void FrameDrawer::orderItems() {
    list_.order(items_, materials_);
    instances_.clear();
    for (const std::uint32_t item : list_.items()) {
        instances_.add(items_[item].placement->instance);
    }
    report_.uploadedBuffers += instances_.upload() ? 1 : 0;
    materialData_.clear();
    for (DrawMaterial& material : materials_) {
        const int vec4s = material.pipeline ? material.pipeline->object.vec4s : 0;
        material.data = materialData_.add(static_cast<std::size_t>(vec4s));
        const int lineVec4s = material.hasLines() ? material.pipeline->outline->vec4s() : 0;
        material.outlineData = materialData_.add(static_cast<std::size_t>(lineVec4s));
    }
    materialData_.makeRoom();
}

/// What the blocks of the frame's materials read in place of computing, where it is not what it
/// was in the last frame.
void FrameDrawer::fillTables(const Scene& scene) {
    tables_.makeRoom(materials_.size());
    for (std::size_t i = 0; i < materials_.size(); ++i) {
        const Pipeline* pipeline = materials_[i].pipeline.get();
        if (pipeline != nullptr && pipeline->tableProgram) {
            const Material& values = scene.objects[materials_[i].object].material;
            report_.filledTables +=
                tables_.fit(i, *pipeline, values, cameras_.cameraToWorld) ? 1 : 0;
        } else {
            tables_.drop(i);
        }
    }
}

void FrameDrawer::noteSource(const void* source) {
    if (std::find(sources_.begin(), sources_.end(), source) == sources_.end()) {
        sources_.push_back(source);
    }
}

} // namespace patina
