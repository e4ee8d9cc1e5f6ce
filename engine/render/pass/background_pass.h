// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// Prepares an environment's light, and draws its picture where no solid object is.
class BackgroundPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;

    /// Ends the step while a software driver is at work on the picture, since what is drawn next
    /// would have to wait for it.
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "background"; }

  private:
    bool isDrawn_ = false;
};

} // namespace patina
