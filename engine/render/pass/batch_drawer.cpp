// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/batch_drawer.h"

#include <epoxy/gl.h>

namespace patina {

bool BatchDrawer::drawTriangles(FrameGpu& gpu, const DrawBatch& batch, StepBudget& budget,
                                int copies) {
    const auto drawn = [&](const DrawRange& range) {
        batch.mesh->draw(gpu.data.instances(), range);
    };
    return drawSlices(gpu, batch, {batch.mesh->triangles(), copies}, budget, drawn);
}

/// Lines are drawn like opaque objects and hide each other by their depth.
bool BatchDrawer::drawLines(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                            StepBudget& budget) {
    if (!frame.hasLines(batch.material) || !batch.mesh->hasEdges() ||
        batch.mesh->edgeCount() == 0) {
        return true;
    }
    gpu.data.feedLines(frame, batch);
    return drawEdges(gpu, batch, budget);
}

/// Fins are drawn with the data of the surface.
bool BatchDrawer::drawFins(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                           StepBudget& budget) {
    const Pipeline& pipeline = *frame.materials[batch.material].pipeline;
    if (!pipeline.finsProgram || !batch.mesh->hasEdges() || batch.mesh->edgeCount() == 0) {
        return true;
    }
    gpu.data.feed(frame, batch);
    pipeline.finsProgram->use();
    gpu.data.forgetProgram();
    return drawEdges(gpu, batch, budget);
}

bool BatchDrawer::drawEdges(FrameGpu& gpu, const DrawBatch& batch, StepBudget& budget) {
    setBlendState(BlendState::Opaque);
    glDepthMask(GL_TRUE);
    const auto drawn = [&](const DrawRange& range) {
        batch.mesh->drawEdges(gpu.data.instances(), range);
    };
    return drawSlices(gpu, batch, {batch.mesh->edgeCount(), 1}, budget, drawn);
}

/// Draws the triangles (or edges) of each of the batch's objects in slices.
bool BatchDrawer::drawSlices(FrameGpu& gpu, const DrawBatch& batch, Amount each, StepBudget& budget,
                             const std::function<void(const DrawRange&)>& draw) {
    while (!slices_.isDone(batch.count)) {
        DrawRange range = slices_.next(each.triangles, batch.first, batch.count,
                                       budget.maxTriangles() / each.copies);
        range.copies = each.copies;
        draw(range);
        ++gpu.report.drawCalls;
        budget.addTriangles(range.total());
        if (!slices_.isDone(batch.count) && budget.isDue()) {
            return false;
        }
    }
    slices_ = DrawSlices();
    return true;
}

} // namespace patina
