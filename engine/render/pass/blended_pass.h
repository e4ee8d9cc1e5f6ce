// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "render/pass/batch_drawer.h"
#include "render/pass/refraction_targets.h"

namespace patina {

/// Draws what is transparent and not put together in layers: each object by itself, far ones first,
/// with its lines. What was drawn before it is what is seen through one that refracts.
class BlendedPass : public Pass {
  public:
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;
    bool draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) override;
    void forget() override { release(); }

    /// Gives the memory of the targets back.
    void release() { refraction_.reset(); }

  private:
    Result<bool> fitRefraction(const FramePlan& plan, FrameGpu& gpu);
    bool drawBatch(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                   StepBudget& budget);
    bool drawSurface(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                     StepBudget& budget);
    bool drawRefracting(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch,
                        StepBudget& budget);
    bool drawBack(const FramePlan& plan, FrameGpu& gpu, const DrawBatch& batch, StepBudget& budget);

    std::size_t batch_ = 0;   ///< of the transparent ones
    bool hasDepths_ = false;  ///< of the batch
    bool hasBack_ = false;    ///< the farthest surface of the batch, where it refracts light
    bool hasSurface_ = false; ///< the batch's, while its lines remain
    BatchDrawer drawer_;
    std::optional<RefractionTargets> refraction_; ///< while something refracts light
};

} // namespace patina
