// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/target_pass.h"

#include <utility>

#include <epoxy/gl.h>

#include "render/gpu/slow_allocation.h"
#include "render/pass/frame_gpu.h"
#include "shading/effects/refraction.h"
#include "shading/program/storable.h"

namespace patina {

Result<bool> TargetPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    isCleared_ = false;
    const bool isRefracted = showsSceneRefracted(*frame.plan.effects, *gpu.shared.catalog);
    const Result<bool> isNew = gpu.fitTarget(frame.plan, isRefracted);
    return isNew ? *isNew && isSlowToAllocate(gpu.target().drawnSize()) : isNew;
}

bool TargetPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget&) {
    if (std::exchange(isCleared_, true)) {
        return true;
    }
    const glm::vec4 color = storable(frame.plan.scene->background);
    gpu.target().bind();
    glClearColor(color.x, color.y, color.z, 1.0f);
    glDepthMask(GL_TRUE);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    return true;
}

} // namespace patina
