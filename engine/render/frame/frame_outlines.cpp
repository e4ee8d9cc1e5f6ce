// SPDX-License-Identifier: GPL-3.0-or-later
// The part of FrameDrawer that draws lines along the edges of objects.
#include <algorithm>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>

#include "render/frame/frame_drawer.h"
#include "render/gpu/binding.h"
#include "shading/program/parameter_packer.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;

/// As the solid objects: lines hide each other by their depth.
void setState() {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

/// Moving a point towards the eye by a share of its distance leaves it where it is on the picture,
/// and changes its depth in clip space by that share (over one less it) of the eye's own.
glm::vec4 pixelInClip(const glm::dmat4& worldToClip, const glm::dvec3& eye, glm::dvec2 size) {
    const double wide = glm::length(glm::dvec3(worldToClip[0].x, worldToClip[1].x,
                                               worldToClip[2].x));
    const double share = std::min(2.0 / (size.x * wide), 0.5);
    const double eyeDepth = (worldToClip * glm::dvec4(eye, 1.0)).z;
    return {2.0 / size.x, 2.0 / size.y, share / (1.0 - share) * eyeDepth, 0.0};
}

} // namespace

void FrameDrawer::measurePixel(const View& view, const glm::dmat4& worldToClip) {
    pixelInClip_ = pixelInClip(worldToClip, eye(view.camera), glm::dvec2(view.size));
}

/// Before a mesh is drawn with lines for the first time.
bool FrameDrawer::findEdges(Deadline deadline) {
    for (const DrawItem& item : items_) {
        if (!materials_[item.material].isOutlined) {
            continue;
        }
        GpuEdges& edges = meshes_.prepareEdges(*item.mesh, item.view);
        while (!edges.isComplete()) {
            edges.proceed(item.view);
            if (Clock::now() >= deadline) {
                return false;
            }
        }
    }
    return true;
}

/// Draws the outlines of the solid objects, once: over them and the ground, and behind what is
/// transparent.
bool FrameDrawer::drawOutlines(const Scene& scene, Deadline deadline) {
    for (; cursor_.outlined < list_.opaqueBatches(); ++cursor_.outlined) {
        if (!drawOutline(scene, list_.batches()[cursor_.outlined], deadline)) {
            return false;
        }
    }
    cursor_.hasOutlines = true;
    return true;
}

bool FrameDrawer::drawOutline(const Scene& scene, const DrawBatch& batch, Deadline deadline) {
    if (!materials_[batch.material].hasLines() || !batch.mesh->hasEdges() ||
        batch.mesh->edgeCount() == 0) {
        return true;
    }
    feedOutline(scene, batch);
    setState();
    return drawSlices(batch, batch.mesh->edgeCount(), deadline, [&](const DrawRange& range) {
        batch.mesh->drawEdges(instances_, range);
    });
}

/// Before the layers, of which those in front are put over them and those behind are hidden.
void FrameDrawer::drawLayerOutlines(const Scene& scene) {
    for (const DrawBatch& batch : transparentBatches()) {
        if (isLayered(materials_[batch.material])) {
            drawOutline(scene, batch, never);
        }
    }
}

void FrameDrawer::feedOutline(const Scene& scene, const DrawBatch& batch) {
    static const Values none;
    const DrawMaterial& material = materials_[batch.material];
    const Pipeline& pipeline = *material.pipeline;
    const OutlineLayout& layout = *pipeline.outline;
    const Material& values = scene.objects[material.object].material;
    const BlockValues* part = values.part(layout.block.block->kind);
    const bool isOfBlock = part != nullptr && part->id == layout.block.block->id;
    feedScene(scene, pipeline, batch.lights);
    const std::span<glm::vec4> data = materialData_.staging(material.outlineData);
    data[OutlineLayout::line] = pixelInClip_;
    packInto(data.subspan(OutlineLayout::fixed), layout.block.layout,
             isOfBlock ? part->parameters : none, values.accuracy, cameras_.cameraToWorld);
    report_.uploadedBuffers += materialData_.upload(material.outlineData) ? 1 : 0;
    materialData_.bind(binding::object, material.outlineData);
    pipeline.outlineProgram->use();
    fedMaterial_.reset(); // another program is in use
}

} // namespace patina
