// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "render/pass/pass.h"

namespace patina {

/// Draws the shadow maps that a frame needs. Views share the maps, so another view may have planned
/// its own since; then they are planned again and, where they differ, drawn again in one step.
/// Otherwise two frames could take them from each other for ever.
class ShadowPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;

    /// Returns how many triangles must still be drawn into maps.
    std::int64_t pendingTriangles(const PreparedFrame& frame, FrameGpu& gpu);

    /// Returns why the frame has no shadows although it should; empty otherwise.
    const std::optional<Error>& error() const { return error_; }

  private:
    void take(const PreparedFrame& frame, FrameGpu& gpu);
    void takeBack(const PreparedFrame& frame, FrameGpu& gpu);

    std::uint64_t taken_ = 0; ///< is ShadowMaps::planNumber() of the frame's own plan
    bool wereLost_ = false;   ///< says that another frame has taken the maps
    std::optional<Error> error_;
};

} // namespace patina
