// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/background_pass.h"

#include <utility>

#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {

Result<bool> BackgroundPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    isDrawn_ = false;
    const Catalog& catalog = *gpu.shared.catalog;
    const SceneToPack packing{*frame.plan.scene, *frame.plan.effects, {}};
    const FrameEnvironment::Shared shared{gpu.shared.programs(), gpu.shared.environments};
    if (frame.plan.isUnseen) {
        gpu.environment.prewarm(packing, *frame.plan.view, catalog, shared);
        return false;
    }
    return gpu.environment.begin(packing, *frame.plan.view, catalog, shared);
}

bool BackgroundPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    if (std::exchange(isDrawn_, true)) {
        return true;
    }
    const glm::dvec2 size(frame.plan.view->size);
    gpu.environment.drawBackground(frame.plan.view->camera, frame.plan.cameraToWorld,
                                   size.x / size.y);
    gpu.data.forgetProgram();
    return budget.isEndless() || !budget.mustStop();
}

} // namespace patina
