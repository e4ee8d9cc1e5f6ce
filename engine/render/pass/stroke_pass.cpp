// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/stroke_pass.h"

#include <algorithm>

#include <epoxy/gl.h>

#include "render/gpu/step_budget.h"
#include "render/pass/frame_gpu.h"

namespace patina {
namespace {

/// Are drawn before the clock is asked.
constexpr std::size_t marksAtOnce = 2048;

/// Is as large as no mesh has marks, so that they never count as too few for a density.
constexpr float endless = 1e30f;

/// Sets the marks' program with what it needs of the view and the mesh.
void useMarks(const Pipeline& pipeline, const FramePlan& plan, const GpuMarks& marks) {
    const bool isFull = marks.isFull();
    pipeline.marksProgram->use();
    const auto unit = static_cast<float>(plan.pixelsPerUnit());
    glUniform4f(pipeline.marksProgram->uniform("markView"), 2.0f * unit / float(plan.view->size.x),
                2.0f * unit / float(plan.view->size.y), unit * float(plan.pixelWidth()),
                isFull ? float(marks.available()) : endless);
    glUniform1f(pipeline.marksProgram->uniform("markPixel"), 1.0f / unit);
    const bool isStanding = areStanding(*pipeline.effects.strokes);
    setBlendState(isStanding ? BlendState::Opaque : BlendState::Blended);
    glDepthMask(isStanding ? GL_TRUE : GL_FALSE);
    // The planes before and behind the scene may touch a surface: its marks reach beyond.
    glEnable(GL_DEPTH_CLAMP);
}

void leaveMarks() {
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_CLAMP);
}

} // namespace

Result<bool> StrokePass::prepare(PreparedFrame&, FrameGpu&) {
    batch_ = 0;
    object_ = 0;
    mark_ = 0;
    return false;
}

bool StrokePass::draw(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    for (; batch_ < frame.list.opaqueBatches(); ++batch_) {
        const DrawBatch& batch = frame.list.batches()[batch_];
        if (!frame.materials[batch.material].pipeline->marksProgram ||
            batch.mesh->knownMarks() == nullptr) {
            continue;
        }
        const bool isDone = drawBatch(frame, gpu, budget);
        leaveMarks();
        if (!isDone) {
            return false;
        }
        object_ = 0;
    }
    return true;
}

/// Draws the marks of each object in slices, since each may cover many pixels.
bool StrokePass::drawBatch(const PreparedFrame& frame, FrameGpu& gpu, StepBudget& budget) {
    const DrawBatch& batch = frame.list.batches()[batch_];
    const GpuMarks& marks = *batch.mesh->knownMarks();
    gpu.data.feed(frame, batch);
    useMarks(*frame.materials[batch.material].pipeline, frame.plan, marks);
    gpu.data.forgetProgram();
    while (object_ < batch.count) {
        const std::size_t instance = batch.first + object_;
        const PlannedItem& item = frame.plan.items[frame.list.items()[instance]];
        const std::size_t count = marks.count(item.marks);
        const std::size_t slice = std::min(count - std::min(mark_, count), marksAtOnce);
        if (slice > 0) {
            marks.draw(gpu.data.instances(), {instance, mark_, slice});
            ++gpu.report.drawCalls;
            budget.addTriangles(2 * static_cast<std::int64_t>(slice));
        }
        mark_ += slice;
        if (mark_ >= count) {
            mark_ = 0;
            ++object_;
        }
        if (object_ < batch.count && !budget.isEndless() && budget.mustStop()) {
            return false;
        }
    }
    return true;
}

} // namespace patina
