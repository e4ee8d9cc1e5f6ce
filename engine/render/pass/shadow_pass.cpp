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
    FrameShadows& shadows = gpu.shadows;
    shadows.begin();
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        const PlannedItem& item = frame.plan.items[i];
        const Object& object = frame.plan.scene->objects[item.index];
        if (object.castsShadow && frame.plan.materials[item.material].canShadow) {
            shadows.addCaster(*frame.meshes[i], {item.view.bounds, item.placement->world},
                              object.material);
        }
    }
    const auto planned =
        shadows.plan(*frame.plan.scene, *frame.plan.effects, frame.plan.cameraToWorld,
                     gpu.shared.programs(), gpu.shared.textures);
    error_ = planned ? std::nullopt : std::optional(planned.error());
    gpu.report.shadowMaps = shadows.pending();
    return shadows.hasNewImages();
}

bool ShadowPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    FrameShadows& shadows = gpu.shadows;
    const bool isAtOnce = budget.isEndless();
    const Result<bool> isHolding = shadows.hold(isAtOnce, gpu.shared.programs());
    if (!isHolding) {
        error_ = isHolding.error();
        return true;
    }
    if (!*isHolding) {
        return false;
    }
    while (!frame.plan.isUnseen && shadows.pending() > 0) {
        shadows.drawSome(isAtOnce ? std::numeric_limits<int>::max() : slice, gpu.textures);
        if (!isAtOnce && budget.mustStop()) {
            return false;
        }
    }
    return true;
}

} // namespace patina
