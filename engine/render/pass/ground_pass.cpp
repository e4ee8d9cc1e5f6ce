// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/ground_pass.h"

#include <limits>
#include <utility>

#include <epoxy/gl.h>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"
#include "render/pass/frame_gpu.h"

namespace patina {
namespace {

void setBlending(GroundMode mode) {
    glEnable(GL_BLEND);
    glDepthFunc(GL_LESS);
    const bool isPlane = mode == GroundMode::Plane;
    glDepthMask(isPlane ? GL_TRUE : GL_FALSE);
    // Shadows multiply what is there.
    glBlendFuncSeparate(isPlane ? GL_SRC_ALPHA : GL_ZERO,
                        isPlane ? GL_ONE_MINUS_SRC_ALPHA : GL_SRC_COLOR, GL_ZERO, GL_ONE);
}

} // namespace

Result<bool> GroundPass::prepare(PreparedFrame& frame, FrameGpu&) {
    isDrawn_ = frame.ground == nullptr;
    if (!isDrawn_) {
        data_.reserve(static_cast<std::size_t>(frame.ground->object.vec4s));
        makeMesh();
    }
    return false;
}

void GroundPass::makeMesh() {
    if (mesh_) {
        return;
    }
    const Mesh square = groundMesh();
    mesh_.emplace(square.view());
    while (!mesh_->isComplete()) {
        mesh_->upload(square.view(), std::numeric_limits<std::size_t>::max());
    }
}

bool GroundPass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget&) {
    if (std::exchange(isDrawn_, true)) {
        return true;
    }
    const PlannedGround& ground = frame.plan.ground;
    const Pipeline& pipeline = *frame.ground;
    gpu.data.feedScene(frame.plan, pipeline, ground.lights);
    packGround(data_.staging(), pipeline, frame.plan.scene->ground,
               {ground.place, gpu.environment.upward()});
    gpu.report.uploadedBuffers +=
        data_.upload(static_cast<std::size_t>(pipeline.object.vec4s)) ? 1 : 0;
    data_.bind(binding::object);
    pipeline.program->use();
    gpu.data.forgetProgram();
    setBlending(pipeline.effects.ground);
    instance_.place(worldMatrix(ground.place));
    mesh_->draw(instance_);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    return true;
}

} // namespace patina
