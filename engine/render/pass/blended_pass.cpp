// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/blended_pass.h"

#include <epoxy/gl.h>

#include "render/gpu/slow_allocation.h"
#include "shading/effects/refraction.h"

namespace patina {
namespace {

/// Returns the object's facets where its program follows rays among them; null where it does not,
/// or there are none.
const ConvexFacets* facetsOf(const PreparedFrame& frame, const DrawBatch& batch) {
    const DrawMaterial& material = frame.materials[batch.material];
    if (!followsFacets(*material.pipeline->object.refraction->block)) {
        return nullptr;
    }
    const PlannedItem& item = frame.plan.items[frame.list.items()[batch.first]];
    const ConvexFacets& facets = batch.mesh->facets(item.view);
    return facets.planes.empty() ? nullptr : &facets;
}

/// Tells whether the farthest surface of the object must be drawn.
bool needsBack(const PreparedFrame& frame, const DrawBatch& batch) {
    const Block& block = *frame.materials[batch.material].pipeline->object.refraction->block;
    return !isSheet(block) && facetsOf(frame, batch) == nullptr;
}

} // namespace

/// Fits the target again where a refracting program reads the scene's colour, since a program kept
/// from before a change may do so when the scene's effects do not.
Result<bool> BlendedPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    batch_ = 0;
    hasDepths_ = false;
    hasBack_ = false;
    hasSurface_ = false;
    drawer_ = BatchDrawer();
    if (auto fitted = fitRefraction(frame, gpu); !fitted || *fitted) {
        return fitted;
    }
    return refraction_ && refraction_->needsSceneColor() ? gpu.fitTarget(frame.plan, true)
                                                         : Result<bool>(false);
}

Result<bool> BlendedPass::fitRefraction(const PreparedFrame& frame, FrameGpu& gpu) {
    RefractionTargets::Needs needs;
    bool isNeeded = false;
    for (const DrawBatch& batch : frame.list.transparentBatches()) {
        const DrawMaterial& material = frame.materials[batch.material];
        if (material.refracts()) {
            isNeeded = true;
            needs.back = needs.back || needsBack(frame, batch);
            needs.behind = needs.behind || material.pipeline->effects.isShownRefracted;
        }
    }
    if (!isNeeded) {
        refraction_.reset();
        return false;
    }
    const bool isNew = !refraction_;
    if (isNew) {
        refraction_.emplace();
    }
    const glm::ivec2 size = gpu.target().averagedSize();
    return refraction_->begin(size, needs, *gpu.shared.catalog, gpu.shared.programs())
        .map([isNew, size] { return isNew && isSlowToAllocate(size); });
}

bool BlendedPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    const std::span<const DrawBatch> batches = frame.list.transparentBatches();
    while (batch_ < batches.size()) {
        const DrawBatch& batch = batches[batch_];
        if (!frame.materials[batch.material].isLayered && !drawBatch(frame, gpu, batch, budget)) {
            return false;
        }
        if (++batch_ < batches.size() && budget.isDue()) {
            return false;
        }
    }
    return true;
}

/// Draws the surface and then its lines, so that objects in front are blended over both.
bool BlendedPass::drawBatch(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                            StepBudget& budget) {
    if (!hasSurface_ && !drawSurface(frame, gpu, batch, budget)) {
        return false;
    }
    hasSurface_ = true;
    if (!drawer_.drawLines(frame, gpu, batch, budget)) {
        return false;
    }
    hasSurface_ = false;
    return true;
}

/// Blends only the nearest layer of a transparent object, so that the order of its triangles does
/// not show: depths first, then colours where the depth is the same.
bool BlendedPass::drawSurface(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                              StepBudget& budget) {
    if (frame.materials[batch.material].refracts()) {
        setBlendState(BlendState::Opaque);
        return drawRefracting(frame, gpu, batch, budget);
    }
    gpu.data.feed(frame, batch);
    if (!hasDepths_) {
        setBlendState(BlendState::Depths);
        if (!drawer_.drawTriangles(gpu, batch, budget)) {
            return false;
        }
    }
    hasDepths_ = true;
    setBlendState(BlendState::Blended);
    if (!drawer_.drawTriangles(gpu, batch, budget)) {
        return false;
    }
    hasDepths_ = false;
    gpu.report.drawnObjects += static_cast<int>(batch.count);
    return true;
}

bool BlendedPass::drawRefracting(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                                 StepBudget& budget) {
    const Pipeline& pipeline = *frame.materials[batch.material].pipeline;
    const Placement& placement = *frame.plan.items[frame.list.items()[batch.first]].placement;
    gpu.data.feed(frame, batch);
    if (needsBack(frame, batch) && !hasBack_ && !drawBack(frame, gpu, batch, budget)) {
        return false;
    }
    hasBack_ = true;
    if (pipeline.effects.isShownRefracted && drawer_.isAtStart()) {
        gpu.data.forgetProgram();
        refraction_->takeBehind(gpu.target());
        gpu.target().bind();
        gpu.data.feed(frame, batch);
    }
    refraction_->bind(*pipeline.program, placement.ball, gpu.target());
    if (followsFacets(*pipeline.object.refraction->block)) {
        const ConvexFacets* facets = facetsOf(frame, batch);
        RefractionTargets::setFacets(*pipeline.program, placement,
                                     facets ? *facets : ConvexFacets());
    }
    if (!drawer_.drawTriangles(gpu, batch, budget)) {
        return false;
    }
    hasBack_ = false;
    ++gpu.report.drawnObjects;
    return true;
}

/// Draws the farthest surface of the object, then sets the object's own program again.
bool BlendedPass::drawBack(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                           StepBudget& budget) {
    const Ball& ball = frame.plan.items[frame.list.items()[batch.first]].placement->ball;
    refraction_->beginBack(ball, drawer_.isAtStart());
    gpu.data.forgetProgram();
    const bool isDrawn = drawer_.drawTriangles(gpu, batch, budget);
    gpu.target().bind();
    glDepthFunc(GL_LESS);
    if (isDrawn) {
        gpu.data.feed(frame, batch);
    }
    return isDrawn;
}

} // namespace patina
