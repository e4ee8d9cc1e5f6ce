// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/gpu/row_tiles.h"
#include "render/pass/batch_drawer.h"

namespace patina {

/// Draws the surfaces of the solid objects: slice by slice where there are many triangles, and tile
/// by tile where it is the pixels of few that take long.
class SolidPass : public Pass {
  public:
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;
    bool draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) override;

    /// Returns how long the frame that was prepared may take, and what it has taken.
    const RowTiles& tiles() const { return tiles_; }
    void noteTime(double milliseconds) { tiles_.noteTime(milliseconds); }

  private:
    bool drawTiles(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget);
    bool drawBatches(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget);

    RowTiles tiles_;
    std::size_t batch_ = 0;
    bool isDone_ = false;
    BatchDrawer drawer_;
};

} // namespace patina
