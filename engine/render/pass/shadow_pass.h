// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "render/pass/pass.h"

namespace patina {

/// The shadow maps that a frame needs. Views share them, so another view's frame may have planned
/// its own since: then they are planned again and, where they differ, drawn again, all in one step.
/// Two frames would take them from each other for ever otherwise.
class ShadowPass : public Pass {
  public:
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;
    bool draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) override;

    /// Triangles that are still to be drawn into maps.
    std::int64_t pendingTriangles(const FramePlan& plan, FrameGpu& gpu);

    /// Why there are no shadows in the frame, if there should be some.
    const std::optional<Error>& error() const { return error_; }

  private:
    void take(const FramePlan& plan, FrameGpu& gpu);
    void takeBack(const FramePlan& plan, FrameGpu& gpu);

    std::uint64_t taken_ = 0; ///< the number of the maps' plan
    bool wereLost_ = false;   ///< to another frame
    std::optional<Error> error_;
};

} // namespace patina
