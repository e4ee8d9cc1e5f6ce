// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/pass/batch_drawer.h"

namespace patina {

/// Draws the lines of the solid objects: over them and the ground, and behind what is transparent.
class OutlinePass : public Pass {
  public:
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;
    bool draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) override;

  private:
    std::size_t batch_ = 0;
    BatchDrawer drawer_;
};

} // namespace patina
