// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/mesh_pass.h"

#include "catalog/block_kind.h"
#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {
namespace {

constexpr std::size_t uploadBytes = std::size_t(4) << 20;

bool readsCurvature(const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    return model != nullptr && model->withRole(roles::placeCurvature) != nullptr;
}

} // namespace

Result<bool> MeshPass::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        frame.meshes[i] = gpu.shared.meshes.prepare(frame.plan.items[i].view);
    }
    return false;
}

bool MeshPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        GpuMesh& mesh = *frame.meshes[i];
        const MeshView& view = frame.plan.items[i].view;
        while (!mesh.isComplete()) {
            mesh.upload(view, uploadBytes);
            if (budget.isOver()) {
                return false;
            }
        }
        mesh.takeOpenness(view);
    }
    takeColors(frame);
    return findEdges(frame, gpu, budget) && findCurvature(frame, gpu, budget) &&
           setMarks(frame, gpu, budget);
}

/// Uploads the colours of meshes whose programs read them.
void MeshPass::takeColors(const PreparedFrame& frame) {
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        const PlannedItem& item = frame.plan.items[i];
        const auto& pipeline = frame.materials[item.material].pipeline;
        if (pipeline && pipeline->effects.readsVertexColors()) {
            frame.meshes[i]->takeColors(item.view);
        }
    }
}

/// Finds and uploads the edges of meshes with outlines or fins; returns false when the budget is
/// used up.
bool MeshPass::findEdges(const PreparedFrame& frame, FrameGpu& gpu, const StepBudget& budget) {
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        const PlannedItem& item = frame.plan.items[i];
        if (!frame.plan.materials[item.material].needsEdges()) {
            continue;
        }
        GpuEdges& edges = gpu.shared.meshes.prepareEdges(*frame.meshes[i], item.view);
        while (!edges.isComplete()) {
            edges.proceed(item.view);
            if (budget.isOver()) {
                return false;
            }
        }
    }
    return true;
}

/// Finds and uploads how meshes bend whose models read it; returns false when the budget is used
/// up.
bool MeshPass::findCurvature(const PreparedFrame& frame, FrameGpu& gpu, const StepBudget& budget) {
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        const PlannedItem& item = frame.plan.items[i];
        if (!readsCurvature(frame.plan.material(item.material), *gpu.shared.catalog)) {
            continue;
        }
        while (!frame.meshes[i]->takeCurvature(item.view)) {
            if (budget.isOver()) {
                return false;
            }
        }
    }
    return true;
}

/// Sets and uploads the marks of meshes with strokes, as many as the nearest of their objects
/// needs; returns false when the budget is used up.
bool MeshPass::setMarks(const PreparedFrame& frame, FrameGpu& gpu, const StepBudget& budget) {
    for (std::size_t i = 0; i < frame.meshes.size(); ++i) {
        const PlannedItem& item = frame.plan.items[i];
        if (!(item.marks > 0.0)) {
            continue;
        }
        GpuMarks& marks = gpu.shared.meshes.prepareMarks(*frame.meshes[i], item.view);
        while (!marks.hasEnough(item.marks)) {
            marks.proceed(item.view, item.marks);
            if (budget.isOver()) {
                return false;
            }
        }
    }
    return true;
}

} // namespace patina
