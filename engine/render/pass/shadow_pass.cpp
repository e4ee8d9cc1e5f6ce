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

Result<bool> ShadowPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    take(frame, gpu);
    wereLost_ = false;
    gpu.report.shadowMaps = gpu.shared.shadows.pending();
    return gpu.shared.shadows.hasNewImages();
}

void ShadowPass::take(const PreparedFrame& frame, FrameGpu& gpu) {
    ShadowMaps& maps = gpu.shared.shadows;
    maps.clearCasters();
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        const PlannedItem& item = frame.plan.items[i];
        const Object& object = frame.plan.scene->objects[item.index];
        if (object.castsShadow && frame.plan.materials[item.material].canShadow) {
            maps.addCaster(*frame.meshes[i], {item.view.bounds, item.placement->world},
                           object.material);
        }
    }
    const auto planned = maps.plan(*frame.plan.scene, *frame.plan.effects, frame.plan.cameraToWorld,
                                   gpu.shared.programs(), gpu.shared.textures);
    error_ = planned ? std::nullopt : std::optional(planned.error());
    taken_ = maps.planNumber();
}

void ShadowPass::takeBack(const PreparedFrame& frame, FrameGpu& gpu) {
    if (taken_ != gpu.shared.shadows.planNumber()) {
        take(frame, gpu);
        wereLost_ = wereLost_ || gpu.shared.shadows.isAnother();
    }
}

std::int64_t ShadowPass::pendingTriangles(const PreparedFrame& frame, FrameGpu& gpu) {
    takeBack(frame, gpu);
    return gpu.shared.shadows.pendingTriangles();
}

bool ShadowPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    takeBack(frame, gpu);
    ShadowMaps& maps = gpu.shared.shadows;
    const bool isAtOnce = budget.isEndless() || wereLost_;
    while (!frame.plan.isUnseen && maps.pending() > 0) {
        maps.drawSome(isAtOnce ? std::numeric_limits<int>::max() : slice, gpu.textures);
        if (!isAtOnce && budget.mustStop()) {
            return false;
        }
    }
    return true;
}

} // namespace patina
