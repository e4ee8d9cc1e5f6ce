// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/layer_pass.h"

#include <algorithm>
#include <utility>

#include "scene/transparency.h"

namespace patina {
namespace {

/// Returns the block that composes the frame's layers; null where none are needed.
const Block* blockFor(const PreparedFrame& frame, const Catalog& catalog) {
    const bool isNeeded =
        frame.plan.effects->part(kinds::transparency) != nullptr &&
        std::ranges::any_of(frame.list.transparentBatches(), [&frame](const DrawBatch& batch) {
            return !frame.materials[batch.material].refracts();
        });
    return isNeeded ? blockOf(frame.plan.effects->parts, kinds::transparency, catalog) : nullptr;
}

} // namespace

Result<bool> LayerPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    batch_ = 0;
    hasLines_ = false;
    drawer_ = BatchDrawer();
    const Block* block = blockFor(frame, *gpu.shared.catalog);
    isDone_ = block == nullptr;
    if (isDone_) {
        composer_.leaveOut();
        return false;
    }
    auto isMade = composer_.begin(gpu.target(), layersOf(frame.plan.transparency(), *block),
                                  *gpu.shared.catalog, gpu.shared.programs());
    if (!isMade || *isMade) {
        return isMade;
    }
    return addMaterials(frame, gpu.shared.programs()).map([] { return false; });
}

/// Returns true when a material's program is made for the layers. One kept from before a change may
/// not be; then its object is blended by itself.
bool LayerPass::isLayered(const DrawMaterial& material) const {
    const Pipeline* pipeline = material.pipeline.get();
    return pipeline != nullptr && pipeline->object.transparency &&
           pipeline->object.isPeeled() == composer_.isPeeled();
}

/// Marks layered materials, adds up their range of depths, and makes their programs for depths;
/// returns after the first program that had to be made.
Result<void> LayerPass::addMaterials(PreparedFrame& frame, ProgramCache& programs) {
    frame.layerDepths = DepthRange();
    for (const DrawBatch& batch : frame.list.transparentBatches()) {
        DrawMaterial& material = frame.materials[batch.material];
        const PlannedItem& item = frame.plan.items[frame.list.items()[batch.first]];
        frame.layerDepths.add(item.view.bounds, frame.plan.worldToCamera * item.placement->world);
        material.isLayered = isLayered(material);
        if (!material.isLayered) {
            continue;
        }
        const int built = programs.builtCount();
        auto added = composer_.addPipeline(material.pipeline, programs);
        if (!added || programs.builtCount() > built) {
            return added;
        }
    }
    return {};
}

bool LayerPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    if (isDone_) {
        return true;
    }
    if (!std::exchange(hasLines_, true)) {
        drawLines(frame, gpu);
        if (!budget.isEndless() && budget.mustStop()) {
            return false;
        }
    }
    isDone_ = compose(frame, gpu, budget);
    if (isDone_) {
        gpu.report.drawnObjects += static_cast<int>(std::ranges::count_if(
            frame.list.transparentBatches(), [&frame](const DrawBatch& batch) {
                return frame.materials[batch.material].isLayered;
            }));
    }
    return isDone_;
}

/// Draws the lines before the layers: layers in front are composed over them, and layers behind are
/// hidden by their depth.
void LayerPass::drawLines(const PreparedFrame& frame, FrameGpu& gpu) {
    StepBudget whole;
    for (const DrawBatch& batch : frame.list.transparentBatches()) {
        if (frame.materials[batch.material].isLayered) {
            drawer_.drawLines(frame, gpu, batch, whole);
        }
    }
}

bool LayerPass::compose(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    const auto drawStage = [&, this](LayerComposer::Stage stage) {
        if (stage == LayerComposer::Stage::Layers) {
            return drawObjects(frame, gpu, stage, budget);
        }
        StepBudget whole; // may overrun a step, but depths are quick
        drawObjects(frame, gpu, stage, whole);
        return budget.isEndless() || !budget.mustStop();
    };
    if (frame.plan.isUnseen) {
        composer_.drawUnseen(gpu.target(), drawStage);
        return true;
    }
    return composer_.draw(gpu.target(), drawStage);
}

/// Draws all layered objects for one stage. Returns false when the budget is used up; the next call
/// continues with batch_.
bool LayerPass::drawObjects(const PreparedFrame& frame, FrameGpu& gpu, LayerComposer::Stage stage,
                            StepBudget& budget) {
    const std::span<const DrawBatch> batches = frame.list.transparentBatches();
    while (batch_ < batches.size()) {
        const DrawBatch& batch = batches[batch_];
        const DrawMaterial& material = frame.materials[batch.material];
        if (material.isLayered) {
            gpu.data.feed(frame, batch);
            if (stage == LayerComposer::Stage::Depths) {
                composer_.useDepths(material.pipeline);
                gpu.data.forgetProgram();
            }
            if (!drawer_.drawTriangles(gpu, batch, budget)) {
                return false;
            }
        }
        if (++batch_ < batches.size() && budget.isDue()) {
            return false;
        }
    }
    batch_ = 0;
    return true;
}

} // namespace patina
