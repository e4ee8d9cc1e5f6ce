// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that draws what bends light: each object by itself, far ones first, with
// what was drawn before it as what is seen through it.
#include <epoxy/gl.h>

#include "render/frame/frame_drawer.h"
#include "render/gpu/long_pieces.h"
#include "shading/effects/opacity.h"
#include "shading/effects/refraction.h"

namespace patina {

/// Asks the program that the material is drawn with, which may be left over from before a change.
bool FrameDrawer::refracts(const DrawMaterial& material) {
    return material.pipeline && material.pipeline->object.refraction.has_value();
}

Result<bool> FrameDrawer::beginRefraction() {
    RefractionPass::Needs needs;
    bool isNeeded = false;
    for (const DrawBatch& batch : transparentBatches()) {
        const DrawMaterial& material = materials_[batch.material];
        if (refracts(material)) {
            isNeeded = true;
            needs.back = needs.back || !isSheet(*material.pipeline->object.refraction->block);
            needs.behind = needs.behind || material.pipeline->effects.isShownRefracted;
        }
    }
    if (!isNeeded) {
        refraction_.reset();
        return false;
    }
    const bool isNew = !refraction_;
    if (isNew) {
        refraction_.emplace();
    }
    const glm::ivec2 size = target_.averagedSize();
    return refraction_->begin(size, needs, *catalog_, pipelines_.programs())
        .map([isNew, size] { return isNew && takesLong(size); });
}

/// In steps as any other object.
bool FrameDrawer::drawRefracting(const Scene& scene, const DrawBatch& batch, Deadline deadline) {
    const Pipeline& pipeline = *materials_[batch.material].pipeline;
    const Ball& ball = items_[list_.items()[batch.first]].placement->ball;
    feed(scene, batch);
    if (!isSheet(*pipeline.object.refraction->block) && !cursor_.hasBack) {
        refraction_->beginBack(ball, cursor_.slices.isAtStart());
        fedMaterial_.reset(); // its program is no longer in use
        const bool isDrawn = drawTriangles(batch, deadline);
        target_.bind();
        glDepthFunc(GL_LESS);
        if (!isDrawn) {
            return false;
        }
        feed(scene, batch);
    }
    cursor_.hasBack = true;
    if (pipeline.effects.isShownRefracted && cursor_.slices.isAtStart()) {
        refraction_->takeBehind(target_);
        target_.bind();
    }
    refraction_->bind(*pipeline.program, ball, target_);
    if (!drawTriangles(batch, deadline)) {
        return false;
    }
    cursor_.hasBack = false;
    ++report_.drawnObjects;
    return true;
}

} // namespace patina
