// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/background_pass.h"

#include <utility>

#include <epoxy/gl.h>

#include "render/gpu/slow_allocation.h"
#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"
#include "shading/effects/refraction.h"
#include "shading/program/storable.h"

namespace patina {

Result<bool> BackgroundPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    isDrawn_ = false;
    const Catalog& catalog = *gpu.shared.catalog;
    auto isNew = gpu.fitTarget(frame.plan, showsSceneRefracted(*frame.plan.effects, catalog));
    if (!isNew || (*isNew && isSlowToAllocate(gpu.target().drawnSize()))) {
        return isNew;
    }
    const SceneToPack packing{*frame.plan.scene, *frame.plan.effects, {}};
    const FrameEnvironment::Shared shared{gpu.shared.programs(), gpu.shared.environments};
    if (frame.plan.isUnseen) {
        gpu.environment.prewarm(packing, *frame.plan.view, catalog, shared);
        return false;
    }
    return gpu.environment.begin(packing, *frame.plan.view, catalog, shared);
}

/// Ends the step while the device is at work on the pixels of the environment, since the next object
/// would have to wait for them.
bool BackgroundPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    if (std::exchange(isDrawn_, true)) {
        return true;
    }
    const glm::vec4 color = storable(frame.plan.scene->background);
    gpu.target().bind();
    glClearColor(color.x, color.y, color.z, 1.0f);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gpu.environment.drawBackground(frame.plan.view->camera, frame.plan.cameraToWorld,
                                   double(frame.plan.view->size.x) /
                                       double(frame.plan.view->size.y));
    return budget.isEndless() || !budget.mustStop();
}

} // namespace patina
