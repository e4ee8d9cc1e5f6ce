// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "render/gpu/draw_slices.h"
#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {

/// Draws the objects of a batch slice by slice, and knows where drawing them goes on.
class BatchDrawer {
  public:
    /// Draws their triangles with what was fed. False where it is time to stop: the next call goes
    /// on there.
    bool drawTriangles(FrameGpu& gpu, const DrawBatch& batch, StepBudget& budget);

    /// Feeds and draws their lines, if they have any, likewise.
    bool drawLines(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                   StepBudget& budget);

    /// Tells whether nothing of a batch is drawn yet, or all of it.
    bool isAtStart() const { return slices_.isAtStart(); }

  private:
    bool drawSlices(FrameGpu& gpu, const DrawBatch& batch, int triangles, StepBudget& budget,
                    const std::function<void(const DrawRange&)>& draw);

    DrawSlices slices_;
};

} // namespace patina
