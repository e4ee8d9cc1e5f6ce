// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/mesh_pass.h"

#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {
namespace {

constexpr std::size_t uploadBytes = std::size_t(4) << 20;

} // namespace

Result<bool> MeshPass::prepare(FramePlan& plan, FrameGpu& gpu) {
    for (DrawItem& item : plan.items) {
        item.mesh = gpu.shared.meshes.prepare(item.view);
    }
    return false;
}

bool MeshPass::draw(const FramePlan& plan, FrameGpu& gpu, StepBudget& budget) {
    for (const DrawItem& item : plan.items) {
        while (!item.mesh->isComplete()) {
            item.mesh->upload(item.view, uploadBytes);
            if (budget.isOver()) {
                return false;
            }
        }
        item.mesh->takeOpenness(item.view);
    }
    return findEdges(plan, gpu, budget);
}

/// Finds and uploads the edges of meshes with outlines; returns false when the budget is used up.
bool MeshPass::findEdges(const FramePlan& plan, FrameGpu& gpu, const StepBudget& budget) {
    for (const DrawItem& item : plan.items) {
        if (!plan.materials[item.material].isOutlined) {
            continue;
        }
        GpuEdges& edges = gpu.shared.meshes.prepareEdges(*item.mesh, item.view);
        while (!edges.isComplete()) {
            edges.proceed(item.view);
            if (budget.isOver()) {
                return false;
            }
        }
    }
    return true;
}

} // namespace patina
