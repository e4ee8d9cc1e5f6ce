// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "render/pass/batch_drawer.h"
#include "render/pass/refraction_targets.h"

namespace patina {

/// Draws the transparent objects that are not composed in layers: each by itself with its outlines,
/// far ones first. A refracting object shows what was drawn before it.
class BlendedPass : public Pass {
  public:
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;
    bool draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) override;
    std::string_view name() const override { return "transparent objects"; }
    void forget() override { release(); }

    /// Frees the memory of the refraction targets.
    void release() { refraction_.reset(); }

  private:
    Result<bool> fitRefraction(const PreparedFrame& frame, FrameGpu& gpu);
    bool drawBatch(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                   StepBudget& budget);
    bool drawSurface(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                     StepBudget& budget);
    bool drawRefracting(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                        StepBudget& budget);
    bool drawBack(const PreparedFrame& frame, FrameGpu& gpu, const DrawBatch& batch,
                  StepBudget& budget);

    std::size_t batch_ = 0;   ///< is an index into the transparent batches
    bool hasDepths_ = false;  ///< says that the depths of the batch are drawn
    bool hasBack_ = false;    ///< says that the farthest surface of a refracting batch is drawn
    bool hasSurface_ = false; ///< says that the surface of the batch is drawn and its lines are not
    BatchDrawer drawer_;
    std::optional<RefractionTargets> refraction_; ///< is empty while nothing refracts light
};

} // namespace patina
