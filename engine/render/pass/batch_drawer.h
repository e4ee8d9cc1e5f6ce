// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "render/gpu/draw_slices.h"
#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {

/// Draws the objects of a batch in slices, and remembers how far it came.
class BatchDrawer {
  public:
    /// Draws triangles of the batch with the program and data in use, each object as `copies`
    /// instances. Returns false when the budget is used up; the next call continues.
    bool drawTriangles(FrameGpu& gpu, const DrawBatch& batch, StepBudget& budget, int copies = 1);

    /// Does the same for the outlines of the batch, whose program and data it sets itself. Returns
    /// true at once when there are none.
    bool drawLines(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                   StepBudget& budget);

    /// Does the same for the fins of the batch.
    bool drawFins(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                  StepBudget& budget);

    /// Returns true between batches: nothing of the batch is drawn yet, or all of it.
    bool isAtStart() const { return slices_.isAtStart(); }

  private:
    /// Says what is drawn of each object: its triangles (or edges), so many times.
    struct Amount {
        int triangles = 0;
        int copies = 1;
    };

    bool drawEdges(FrameGpu& gpu, const DrawBatch& batch, StepBudget& budget);
    bool drawSlices(FrameGpu& gpu, const DrawBatch& batch, Amount each, StepBudget& budget,
                    const std::function<void(const DrawRange&)>& draw);

    DrawSlices slices_;
};

} // namespace patina
