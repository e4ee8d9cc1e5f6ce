// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "render/pass/batch_drawer.h"

namespace patina {

/// Draws the fins of solid objects: strands on the edges of their meshes along silhouettes, where
/// the layers of SolidPass leave gaps.
class FinPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "fins of strands"; }

  private:
    std::size_t batch_ = 0;
    BatchDrawer drawer_;
};

} // namespace patina
