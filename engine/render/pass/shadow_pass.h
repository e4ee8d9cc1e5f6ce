// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "render/pass/pass.h"

namespace patina {

/// Draws the shadow maps that a frame needs, in steps.
class ShadowPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "shadow maps"; }

    /// Returns why the frame has no shadows although it should; empty otherwise.
    const std::optional<Error>& error() const { return error_; }

  private:
    std::optional<Error> error_;
};

} // namespace patina
