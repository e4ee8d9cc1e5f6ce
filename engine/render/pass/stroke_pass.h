// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/pass/pass.h"
#include "render/plan/draw_list.h"

namespace patina {

/// Draws the marks of strokes over solid objects and the ground, before outlines.
class StrokePass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "strokes"; }

  private:
    bool drawBatch(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget);

    std::size_t batch_ = 0;
    std::size_t object_ = 0; ///< is the next object of the batch
    std::size_t mark_ = 0;   ///< is the next mark of the object
};

} // namespace patina
