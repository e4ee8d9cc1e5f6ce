// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/resolve_pass.h"

#include <utility>

#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {

Result<bool> ResolvePass::prepare(PreparedFrame&, FrameGpu&) {
    isResolved_ = false;
    isAdded_ = false;
    return false;
}

/// Adds to the mean of an environment's frames in a step of its own.
bool ResolvePass::draw(const PreparedFrame&, FrameGpu& gpu, StepBudget& budget) {
    if (!budget.deviceIsDone()) {
        return false;
    }
    const bool isInMean = gpu.environment.isSampled();
    if (!std::exchange(isResolved_, true)) {
        gpu.target().resolve();
        gpu.target().stretch();
        if (isInMean && !budget.isEndless() && budget.mustStop()) {
            return false;
        }
    }
    if (!std::exchange(isAdded_, true)) {
        if (isInMean) {
            gpu.environment.add(gpu.target().resolved());
        }
        if (!budget.isEndless()) {
            budget.mark();
        }
    }
    return budget.deviceIsDone();
}

} // namespace patina
