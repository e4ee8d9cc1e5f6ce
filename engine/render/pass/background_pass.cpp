// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/background_pass.h"

#include <utility>

#include <epoxy/gl.h>

#include "render/gpu/slow_allocation.h"
#include "render/pass/frame_gpu.h"
#include "shading/effects/refraction.h"
#include "shading/program/storable.h"

namespace patina {

Result<bool> BackgroundPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    isDrawn_ = false;
    const Catalog& catalog = *gpu.shared.catalog;
    auto isNew = gpu.fitTarget(plan, showsSceneRefracted(*plan.effects, catalog));
    if (!isNew || (*isNew && isSlowToAllocate(gpu.target().drawnSize()))) {
        return isNew;
    }
    const SceneToPack packing{*plan.scene, *plan.effects, {}};
    const FrameEnvironment::Shared shared{gpu.shared.programs(), gpu.shared.environments};
    if (plan.isUnseen) {
        gpu.environment.prewarm(packing, *plan.view, catalog, shared);
        return false;
    }
    return gpu.environment.begin(packing, *plan.view, catalog, shared);
}

bool BackgroundPass::draw(const FramePlan& plan, FrameGpu& gpu, StepBudget&) {
    if (std::exchange(isDrawn_, true)) {
        return true;
    }
    const glm::vec4 color = storable(plan.scene->background);
    gpu.target().bind();
    glClearColor(color.x, color.y, color.z, 1.0f);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gpu.environment.drawBackground(plan.view->camera, plan.cameraToWorld,
                                   double(plan.view->size.x) / double(plan.view->size.y));
    return true;
}

} // namespace patina
