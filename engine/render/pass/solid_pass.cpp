// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/solid_pass.h"

namespace patina {

Result<bool> SolidPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    batch_ = 0;
    isDone_ = false;
    drawer_ = BatchDrawer();
    tiles_.begin(frame.sources, gpu.target().drawnSize(), frame.plan.triangles,
                 gpu.environment.rounds());
    return false;
}

bool SolidPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    if (!isDone_) {
        const bool isInTiles = !budget.isEndless() && !frame.plan.hasManyTriangles();
        isDone_ = isInTiles ? drawTiles(frame, gpu, budget) : drawBatches(frame, gpu, budget);
    }
    return isDone_;
}

/// Draws all batches in each tile; returns false when the budget is used up.
bool SolidPass::drawTiles(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    StepBudget whole;
    tiles_.passed(StepBudget::Clock::now()); // is for a tile that the last step did not wait for
    while (!tiles_.isDone()) {
        gpu.report.drawnObjects = 0;
        gpu.report.drawCalls = 0;
        batch_ = 0;
        tiles_.enter(StepBudget::Clock::now());
        drawBatches(frame, gpu, whole);
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

bool SolidPass::drawBatches(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    while (batch_ < frame.list.opaqueBatches()) {
        const DrawBatch& batch = frame.list.batches()[batch_];
        gpu.data.feed(frame, batch);
        setBlendState(BlendState::Opaque);
        const int copies = instancesOf(frame.materials[batch.material].pipeline->effects);
        if (!drawer_.drawTriangles(gpu, batch, budget, copies)) {
            return false;
        }
        gpu.report.drawnObjects += static_cast<int>(batch.count);
        if (++batch_ < frame.list.batches().size() && budget.isDue()) {
            return false;
        }
    }
    return true;
}

} // namespace patina
