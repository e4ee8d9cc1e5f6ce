// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// Draws what is behind the objects: the target, cleared, and an environment's picture.
class BackgroundPass : public Pass {
  public:
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;
    bool draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) override;

  private:
    bool isDrawn_ = false;
};

} // namespace patina
