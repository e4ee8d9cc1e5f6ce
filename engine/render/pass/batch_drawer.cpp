// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/batch_drawer.h"

#include <epoxy/gl.h>

namespace patina {

bool BatchDrawer::drawTriangles(FrameGpu& gpu, const DrawBatch& batch, StepBudget& budget) {
    return drawSlices(gpu, batch, batch.mesh->triangles(), budget, [&](const DrawRange& range) {
        batch.mesh->draw(gpu.data.instances(), range);
    });
}

/// Lines are drawn like opaque objects and hide each other by their depth.
bool BatchDrawer::drawLines(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                            StepBudget& budget) {
    if (!frame.hasLines(batch.material) || !batch.mesh->hasEdges() ||
        batch.mesh->edgeCount() == 0) {
        return true;
    }
    gpu.data.feedLines(frame, batch);
    setBlendState(BlendState::Opaque);
    glDepthMask(GL_TRUE);
    return drawSlices(gpu, batch, batch.mesh->edgeCount(), budget, [&](const DrawRange& range) {
        batch.mesh->drawEdges(gpu.data.instances(), range);
    });
}

/// Draws all `triangles` (or edges) of each of the batch's objects in slices.
bool BatchDrawer::drawSlices(FrameGpu& gpu, const DrawBatch& batch, int triangles,
                             StepBudget& budget,
                             const std::function<void(const DrawRange&)>& draw) {
    while (!slices_.isDone(batch.count)) {
        const DrawRange range =
            slices_.next(triangles, batch.first, batch.count, budget.maxTriangles());
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
