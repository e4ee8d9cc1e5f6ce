// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/pass/pass.h"

namespace patina {

/// Makes the picture from what is drawn: it averages the samples, stretches the result and adds it
/// to the mean of an environment's frames.
class ResolvePass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "resolve"; }

  private:
    bool isResolved_ = false;
    bool isAdded_ = false; ///< says that the frame is added to the mean of an environment's frames
};

} // namespace patina
