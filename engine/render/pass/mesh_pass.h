// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// Brings the meshes of a frame and the edges that have lines into the GPU's memory.
class MeshPass : public Pass {
  public:
    /// Makes room for them.
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;

    /// Brings their content, some megabytes at a time.
    bool draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) override;

  private:
    static bool findEdges(const FramePlan& plan, FrameGpu& gpu, const StepBudget& budget);
};

} // namespace patina
