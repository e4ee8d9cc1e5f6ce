// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/frame_data.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"
#include "render/pass/frame_gpu.h"
#include "render/pass/refraction_packer.h"
#include "shading/program/parameter_packer.h"

namespace patina {
namespace {

/// Returns OutlineLayout::line: the size of a pixel in clip space, and the depth that moves a line
/// towards the eye by the width of a pixel. A point moved towards the eye by a share of its
/// distance stays at its place in the picture; its depth in clip space changes by share / (1 -
/// share) times the eye's own.
glm::vec4 pixelInClipOf(const glm::dmat4& worldToClip, const glm::dvec3& eye, glm::dvec2 size) {
    const double wide =
        glm::length(glm::dvec3(worldToClip[0].x, worldToClip[1].x, worldToClip[2].x));
    const double share = std::min(2.0 / (size.x * wide), 0.5);
    const double eyeDepth = (worldToClip * glm::dvec4(eye, 1.0)).z;
    return {2.0 / size.x, 2.0 / size.y, share / (1.0 - share) * eyeDepth, 0.0};
}

PackedAround around(const FramePlan& plan) {
    return {plan.cameraToWorld, plan.scene->wavelengths, plan.view->pixelRatio};
}

} // namespace

FrameData::FrameData(FrameGpu& gpu) : gpu_(gpu) {
    view_.reserve(ViewLayout::vec4s);
}

Result<bool> FrameData::prepare(PreparedFrame& frame, FrameGpu& gpu) {
    lostLights_ = 0;
    makeRoomForLights(frame.plan.lightLists.count());
    writeView(frame.plan, gpu.target().pixelWidth());
    frame.list.order({frame.plan, frame.meshes, frame.materials});
    instances_.clear();
    for (const std::uint32_t item : frame.list.items()) {
        instances_.add(frame.plan.items[item].placement->instance);
    }
    note(instances_.upload());
    placeMaterials(frame);
    fillTables(frame);
    fitLobes(frame);
    return false;
}

void FrameData::note(bool isWritten) {
    gpu_.report.uploadedBuffers += isWritten ? 1 : 0;
}

void FrameData::makeRoomForLights(std::size_t lists) {
    const auto capacity = static_cast<std::size_t>(gpu_.shared.pipelines.sceneCapacity());
    while (scenes_.size() < lists) {
        scenes_.emplace_back().reserve(capacity);
        fedScenes_.push_back(nullptr);
    }
}

void FrameData::writeView(const FramePlan& plan, double pixelWidth) {
    const glm::dmat4 worldToClip = plan.worldToClip();
    pixelInClip_ = pixelInClipOf(worldToClip, plan.eye, glm::dvec2(plan.view->size));
    packView(view_.staging(), worldToClip, plan.eye, pixelWidth);
    note(view_.upload(ViewLayout::vec4s));
    view_.bind(binding::view);
}

void FrameData::placeMaterials(PreparedFrame& frame) {
    materials_.clear();
    for (std::size_t i = 0; i < frame.materials.size(); ++i) {
        DrawMaterial& material = frame.materials[i];
        const int vec4s = material.pipeline ? material.pipeline->object.vec4s : 0;
        material.data = materials_.add(static_cast<std::size_t>(vec4s));
        const int lineVec4s = frame.hasLines(i) ? material.pipeline->outline->vec4s() : 0;
        material.outlineData = materials_.add(static_cast<std::size_t>(lineVec4s));
    }
    materials_.makeRoom();
}

/// Fills the tables that blocks of materials read instead of computing, where they have changed
/// since the last frame.
void FrameData::fillTables(const PreparedFrame& frame) {
    tables_.makeRoom(frame.materials.size());
    for (std::size_t i = 0; i < frame.materials.size(); ++i) {
        const Pipeline* pipeline = frame.materials[i].pipeline.get();
        if (pipeline != nullptr && pipeline->tableProgram) {
            const Material& values = frame.plan.material(i);
            gpu_.report.filledTables +=
                tables_.fit(i, *pipeline, values, around(frame.plan)) ? 1 : 0;
        } else {
            tables_.drop(i);
        }
    }
}

/// Fits the lobes of the frame's materials where they have changed since the last frame.
void FrameData::fitLobes(const PreparedFrame& frame) {
    lobes_.makeRoom(frame.materials.size());
    for (std::size_t i = 0; i < frame.materials.size(); ++i) {
        const Pipeline* pipeline = frame.materials[i].pipeline.get();
        if (pipeline != nullptr && pipeline->lobeFit) {
            const Material& values = frame.plan.material(i);
            const SharedTable measured = bindMeasured(*pipeline, values);
            gpu_.report.filledTables +=
                lobes_.fit(i, *pipeline, values, around(frame.plan), measured) ? 1 : 0;
        } else if (pipeline == nullptr || !pipeline->effects.environment) {
            lobes_.drop(i); // not where light is sampled for now: it is fitted again while the
                            // scene changes
        }
    }
}

void FrameData::bind() {
    view_.bind(binding::view);
    std::fill(fedScenes_.begin(), fedScenes_.end(), nullptr);
    forgetProgram();
}

void FrameData::feed(const PreparedFrame& frame, const DrawBatch& batch) {
    const DrawMaterial& material = frame.materials[batch.material];
    feedScene(frame.plan, *material.pipeline, batch.lights);
    if (fedMaterial_ != batch.material) {
        feedMaterial(frame, batch.material);
        fedMaterial_ = batch.material;
    }
}

void FrameData::feedMaterial(const PreparedFrame& frame, std::size_t number) {
    const DrawMaterial& material = frame.materials[number];
    const Pipeline& pipeline = *material.pipeline;
    const std::span<glm::vec4> data = materials_.staging(material.data);
    const Material& values = frame.plan.material(number);
    if (pipeline.tableProgram) {
        tables_.bind(number);
    }
    if (pipeline.lobeFit) {
        lobes_.bind(number);
    }
    packMaterial(data, pipeline, values, around(frame.plan));
    if (material.isLayered) {
        packLayers(data, pipeline,
                   {frame.plan.transparency().parameters, frame.layerDepths.near(),
                    frame.layerDepths.far()},
                   frame.plan.cameraToWorld);
    }
    if (material.refracts()) {
        packRefraction(data, pipeline, values, *frame.plan.scene);
    }
    gpu_.textures.bind(data, pipeline, values);
    bindMeasured(pipeline, values);
    note(materials_.upload(material.data));
    materials_.bind(binding::object, material.data);
    pipeline.program->use();
}

SharedTable FrameData::bindMeasured(const Pipeline& pipeline, const Material& material) {
    return pipeline.effects.model ? gpu_.shared.measured.bind(pipeline.effects.model->block(),
                                                              material.model.parameters)
                                  : nullptr;
}

void FrameData::feedLines(const PreparedFrame& frame, const DrawBatch& batch) {
    const DrawMaterial& material = frame.materials[batch.material];
    const Pipeline& pipeline = *material.pipeline;
    feedScene(frame.plan, pipeline, batch.lights);
    const std::span<glm::vec4> data = materials_.staging(material.outlineData);
    data[OutlineLayout::line] = pixelInClip_;
    packLines(data, *pipeline.outline, frame.plan.material(batch.material), around(frame.plan));
    note(materials_.upload(material.outlineData));
    materials_.bind(binding::object, material.outlineData);
    pipeline.outlineProgram->use();
    forgetProgram();
}

/// Packs the block again only for another scene key: programs made for the same scene read the same
/// data, but one kept from before a change may read other data.
void FrameData::feedScene(const FramePlan& plan, const Pipeline& pipeline, std::size_t lights) {
    UniformBuffer& data = scenes_[lights];
    const Pipeline* fed = fedScenes_[lights];
    if (fed == nullptr || fed->sceneKey != pipeline.sceneKey || fed->catalog != pipeline.catalog) {
        const PackedScene packed =
            packScene(data.staging(), pipeline,
                      {*plan.scene, *plan.effects, gpu_.shadows.views(), &plan.lightLists, lights},
                      plan.cameraToWorld);
        note(data.upload(packed.vec4s));
        lostLights_ = std::max(lostLights_, packed.lostLights);
        fedScenes_[lights] = &pipeline;
    }
    data.bind(binding::scene);
}

} // namespace patina
