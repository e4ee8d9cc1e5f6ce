// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_pass.h"

#include <limits>

#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {
namespace {

/// Is how many triangles are drawn before the clock is asked.
constexpr int slice = 16384;

} // namespace

Result<bool> ShadowPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    take(plan, gpu);
    wereLost_ = false;
    gpu.report.shadowMaps = gpu.shared.shadows.pending();
    return gpu.shared.shadows.hasNewImages();
}

void ShadowPass::take(const FramePlan& plan, FrameGpu& gpu) {
    ShadowMaps& maps = gpu.shared.shadows;
    maps.clearCasters();
    for (const DrawItem& item : plan.items) {
        const Object& object = plan.scene->objects[item.index];
        if (object.castsShadow && plan.materials[item.material].canShadow) {
            maps.addCaster(*item.mesh, {item.view.bounds, item.placement->world}, object.material);
        }
    }
    const auto planned = maps.plan(*plan.scene, *plan.effects, plan.cameraToWorld,
                                   gpu.shared.programs(), gpu.shared.textures);
    error_ = planned ? std::nullopt : std::optional(planned.error());
    taken_ = maps.planNumber();
}

void ShadowPass::takeBack(const FramePlan& plan, FrameGpu& gpu) {
    if (taken_ != gpu.shared.shadows.planNumber()) {
        take(plan, gpu);
        wereLost_ = wereLost_ || gpu.shared.shadows.isAnother();
    }
}

std::int64_t ShadowPass::pendingTriangles(const FramePlan& plan, FrameGpu& gpu) {
    takeBack(plan, gpu);
    return gpu.shared.shadows.pendingTriangles();
}

bool ShadowPass::draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) {
    takeBack(plan, gpu);
    ShadowMaps& maps = gpu.shared.shadows;
    const bool isAtOnce = budget.isEndless() || wereLost_;
    while (!plan.isUnseen && maps.pending() > 0) {
        maps.drawSome(isAtOnce ? std::numeric_limits<int>::max() : slice, gpu.textures);
        if (!isAtOnce && budget.mustStop()) {
            return false;
        }
    }
    return true;
}

} // namespace patina
