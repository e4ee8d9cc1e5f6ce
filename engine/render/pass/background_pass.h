// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// Clears the target to the background colour and draws an environment's picture behind the
/// objects.
class BackgroundPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;

  private:
    bool isDrawn_ = false;
};

} // namespace patina
