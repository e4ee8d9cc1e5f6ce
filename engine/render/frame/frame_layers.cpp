// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that draws what shines through in no order of its objects.
#include <algorithm>
#include <span>
#include <utility>

#include <epoxy/gl.h>

#include "render/frame/frame_drawer.h"
#include "render/pass/data_packer.h"
#include "scene/transparency.h"

namespace patina {
namespace {

/// The scene's values for the block that the programs have.
const BlockValues& valuesOf(const Scene& scene, const Scene& effects) {
    const BlockValues* own = scene.part(kinds::transparency);
    const BlockValues* drawn = effects.part(kinds::transparency);
    return own != nullptr && own->id == drawn->id ? *own : *drawn;
}

} // namespace

/// A program that is left over from before a change may know nothing of layers: its object is
/// blended by itself.
bool FrameDrawer::isLayered(const DrawMaterial& material) const {
    const Pipeline* pipeline = material.pipeline.get();
    return transparency_.isIn() && pipeline != nullptr && pipeline->object.transparency &&
           pipeline->object.isPeeled() == transparency_.isPeeled();
}

std::span<const DrawBatch> FrameDrawer::transparentBatches() const {
    return list_.batches().subspan(list_.opaqueBatches());
}

Result<bool> FrameDrawer::beginLayers(const Scene& scene) {
    const bool isNeeded = effects_->part(kinds::transparency) != nullptr &&
                          std::ranges::any_of(transparentBatches(), [this](const DrawBatch& batch) {
                              return !refracts(materials_[batch.material]);
                          });
    const Block* block =
        isNeeded ? blockOf(effects_->parts, kinds::transparency, *catalog_) : nullptr;
    if (block == nullptr) {
        transparency_.leaveOut();
        return false;
    }
    const auto isMade = transparency_.begin(target_, layersOf(valuesOf(scene, *effects_), *block),
                                            *catalog_, pipelines_.programs());
    if (!isMade || *isMade) {
        return isMade;
    }
    return addLayers().map([] { return false; });
}

/// Their programs for depths, until one was made, and how deep they reach.
Result<void> FrameDrawer::addLayers() {
    layerDepths_ = DepthRange();
    for (const DrawBatch& batch : transparentBatches()) {
        const DrawMaterial& material = materials_[batch.material];
        const DrawItem& item = items_[list_.items()[batch.first]];
        layerDepths_.add(item.view.bounds, cameras_.worldToCamera * item.placement->world);
        if (!isLayered(material)) {
            continue;
        }
        const int built = pipelines_.programs().builtCount();
        auto added = transparency_.addPipeline(material.pipeline, pipelines_.programs());
        if (!added || pipelines_.programs().builtCount() > built) {
            return added;
        }
    }
    return {};
}

void FrameDrawer::packLayersOf(const Scene& scene, const DrawMaterial& material,
                               std::span<glm::vec4> data) {
    packLayers(data, *material.pipeline,
               {valuesOf(scene, *effects_).parameters, layerDepths_.near(), layerDepths_.far()},
               cameras_.cameraToWorld);
}

bool FrameDrawer::drawLayers(const Scene& scene, Deadline deadline) {
    if (!transparency_.isIn() || cursor_.hasLayers) {
        return true;
    }
    if (!std::exchange(cursor_.hasLayerLines, true)) {
        drawLayerOutlines(scene);
        if (deadline != never && mustStop(deadline)) {
            return false;
        }
    }
    const auto drawObjects = [this, &scene, deadline](TransparencyPass::Stage stage) {
        if (stage == TransparencyPass::Stage::Layers) {
            return drawLayer(scene, stage, deadline);
        }
        drawLayer(scene, stage, never); // quick, but maybe at the end of a step
        return deadline == never || !mustStop(deadline);
    };
    if (isUnseen_) {
        transparency_.drawUnseen(target_, drawObjects);
    }
    cursor_.hasLayers = isUnseen_ || transparency_.draw(target_, drawObjects);
    if (cursor_.hasLayers) {
        report_.drawnObjects += static_cast<int>(
            std::ranges::count_if(transparentBatches(), [this](const DrawBatch& batch) {
                return isLayered(materials_[batch.material]);
            }));
    }
    return cursor_.hasLayers;
}

/// All that is in layers; false where it goes on with the batch at the cursor.
bool FrameDrawer::drawLayer(const Scene& scene, TransparencyPass::Stage stage, Deadline deadline) {
    const std::span<const DrawBatch> batches = transparentBatches();
    while (cursor_.layered < batches.size()) {
        const DrawBatch& batch = batches[cursor_.layered];
        if (isLayered(materials_[batch.material])) {
            feed(scene, batch);
            if (stage == TransparencyPass::Stage::Depths) {
                transparency_.useDepths(materials_[batch.material].pipeline);
                fedMaterial_.reset(); // its program is no longer in use
            }
            if (!drawTriangles(batch, deadline)) {
                return false;
            }
        }
        if (++cursor_.layered < batches.size() && isDue(deadline)) {
            return false;
        }
    }
    cursor_.layered = 0;
    return true;
}

} // namespace patina
