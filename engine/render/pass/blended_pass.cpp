// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/blended_pass.h"

#include <epoxy/gl.h>

#include "render/gpu/slow_allocation.h"
#include "shading/effects/refraction.h"

namespace patina {
namespace {

/// Returns the object's facets where its program follows rays among them; null where it does not,
/// or there are none.
const ConvexFacets* facetsOf(const FramePlan& plan, const DrawBatch& batch) {
    const DrawMaterial& material = plan.materials[batch.material];
    if (!followsFacets(*material.pipeline->object.refraction->block)) {
        return nullptr;
    }
    const DrawItem& item = plan.items[plan.list.items()[batch.first]];
    const ConvexFacets& facets = batch.mesh->facets(item.view);
    return facets.planes.empty() ? nullptr : &facets;
}

/// Tells whether the farthest surface of the object must be drawn.
bool needsBack(const FramePlan& plan, const DrawBatch& batch) {
    const Block& block = *plan.materials[batch.material].pipeline->object.refraction->block;
    return !isSheet(block) && facetsOf(plan, batch) == nullptr;
}

} // namespace

/// Fits the target again where a refracting program reads the scene's colour, since a program kept
/// from before a change may do so when the scene's effects do not.
Result<bool> BlendedPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    batch_ = 0;
    hasDepths_ = false;
    hasBack_ = false;
    hasSurface_ = false;
    drawer_ = BatchDrawer();
    if (auto fitted = fitRefraction(plan, gpu); !fitted || *fitted) {
        return fitted;
    }
    return refraction_ && refraction_->needsSceneColor() ? gpu.fitTarget(plan, true)
                                                         : Result<bool>(false);
}

Result<bool> BlendedPass::fitRefraction(const FramePlan& plan, FrameGpu& gpu) {
    RefractionTargets::Needs needs;
    bool isNeeded = false;
    for (const DrawBatch& batch : plan.list.transparentBatches()) {
        const DrawMaterial& material = plan.materials[batch.material];
        if (material.refracts()) {
            isNeeded = true;
            needs.back = needs.back || needsBack(plan, batch);
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

bool BlendedPass::draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) {
    const std::span<const DrawBatch> batches = plan.list.transparentBatches();
    while (batch_ < batches.size()) {
        const DrawBatch& batch = batches[batch_];
        if (!plan.materials[batch.material].isLayered && !drawBatch(plan, gpu, batch, budget)) {
            return false;
        }
        if (++batch_ < batches.size() && budget.isDue()) {
            return false;
        }
    }
    return true;
}

/// Draws the surface and then its lines, so that objects in front are blended over both.
bool BlendedPass::drawBatch(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                            StepBudget& budget) {
    if (!hasSurface_ && !drawSurface(plan, gpu, batch, budget)) {
        return false;
    }
    hasSurface_ = true;
    if (!drawer_.drawLines(plan, gpu, batch, budget)) {
        return false;
    }
    hasSurface_ = false;
    return true;
}

/// Blends only the nearest layer of a transparent object, so that the order of its triangles does
/// not show: depths first, then colours where the depth is the same.
bool BlendedPass::drawSurface(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                              StepBudget& budget) {
    if (plan.materials[batch.material].refracts()) {
        setBlendState(BlendState::Opaque);
        return drawRefracting(plan, gpu, batch, budget);
    }
    gpu.data.feed(plan, batch);
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

bool BlendedPass::drawRefracting(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                                 StepBudget& budget) {
    const Pipeline& pipeline = *plan.materials[batch.material].pipeline;
    const Placement& placement = *plan.items[plan.list.items()[batch.first]].placement;
    gpu.data.feed(plan, batch);
    if (needsBack(plan, batch) && !hasBack_ && !drawBack(plan, gpu, batch, budget)) {
        return false;
    }
    hasBack_ = true;
    if (pipeline.effects.isShownRefracted && drawer_.isAtStart()) {
        refraction_->takeBehind(gpu.target());
        gpu.target().bind();
    }
    refraction_->bind(*pipeline.program, placement.ball, gpu.target());
    if (followsFacets(*pipeline.object.refraction->block)) {
        const ConvexFacets* facets = facetsOf(plan, batch);
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
bool BlendedPass::drawBack(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                           StepBudget& budget) {
    const Ball& ball = plan.items[plan.list.items()[batch.first]].placement->ball;
    refraction_->beginBack(ball, drawer_.isAtStart());
    gpu.data.forgetProgram();
    const bool isDrawn = drawer_.drawTriangles(gpu, batch, budget);
    gpu.target().bind();
    glDepthFunc(GL_LESS);
    if (isDrawn) {
        gpu.data.feed(plan, batch);
    }
    return isDrawn;
}

} // namespace patina
