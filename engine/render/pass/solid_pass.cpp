// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/solid_pass.h"

namespace patina {

Result<bool> SolidPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    batch_ = 0;
    isDone_ = false;
    drawer_ = BatchDrawer();
    tiles_.begin(plan.sources, gpu.target().drawnSize(), plan.triangles, gpu.environment.rounds());
    return false;
}

bool SolidPass::draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) {
    if (!isDone_) {
        const bool isInTiles = !budget.isEndless() && !plan.hasManyTriangles();
        isDone_ = isInTiles ? drawTiles(plan, gpu, budget) : drawBatches(plan, gpu, budget);
    }
    return isDone_;
}

/// Draws all batches in each tile; returns false when the budget is used up.
bool SolidPass::drawTiles(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) {
    StepBudget whole;
    tiles_.passed(StepBudget::Clock::now()); // is for a tile that the last step did not wait for
    while (!tiles_.isDone()) {
        gpu.report.drawnObjects = 0;
        gpu.report.drawCalls = 0;
        batch_ = 0;
        tiles_.enter(StepBudget::Clock::now());
        drawBatches(plan, gpu, whole);
        RowTiles::leave();
        budget.mark();
        if (!budget.deviceIsDone()) {
            return false;
        }
        tiles_.passed(StepBudget::Clock::now());
        if (budget.isOver()) {
            break;
        }
    }
    return tiles_.isDone();
}

bool SolidPass::drawBatches(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) {
    while (batch_ < plan.list.opaqueBatches()) {
        const DrawBatch& batch = plan.list.batches()[batch_];
        gpu.data.feed(plan, batch);
        setBlendState(BlendState::Opaque);
        if (!drawer_.drawTriangles(gpu, batch, budget)) {
            return false;
        }
        gpu.report.drawnObjects += static_cast<int>(batch.count);
        if (++batch_ < plan.list.batches().size() && budget.isDue()) {
            return false;
        }
    }
    return true;
}

} // namespace patina
