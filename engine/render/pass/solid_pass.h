// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/gpu/row_tiles.h"
#include "render/pass/batch_drawer.h"

namespace patina {

/// Draws the surfaces of solid objects: in slices where there are many triangles, and in tiles
/// where the pixels of few triangles take long.
class SolidPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "solid objects"; }

    /// Returns the tiles of the frame that was prepared.
    const RowTiles& tiles() const { return tiles_; }
    void noteTime(double milliseconds) { tiles_.noteTime(milliseconds); }

  private:
    bool drawTiles(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget);
    bool drawBatches(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget);

    RowTiles tiles_;
    std::size_t batch_ = 0;
    bool isDone_ = false;
    BatchDrawer drawer_;
};

} // namespace patina
