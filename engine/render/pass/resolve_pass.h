// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// From what is drawn to the picture: the mean of its samples, stretched, in the mean of an
/// environment's frames.
class ResolvePass : public Pass {
  public:
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;
    bool draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) override;

  private:
    bool isResolved_ = false;
    bool isAdded_ = false; ///< to the mean of an environment's frames
};

} // namespace patina
