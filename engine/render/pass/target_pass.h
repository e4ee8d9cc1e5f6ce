// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// Makes the image that a frame is drawn into, and clears it to the background colour.
class TargetPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "targets"; }

  private:
    bool isCleared_ = false;
};

} // namespace patina
