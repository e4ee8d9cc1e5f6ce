// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/pass/batch_drawer.h"

namespace patina {

/// Draws the outlines of the solid objects, over these and the ground, and before transparent
/// objects.
class OutlinePass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "outlines"; }

  private:
    std::size_t batch_ = 0;
    BatchDrawer drawer_;
};

} // namespace patina
