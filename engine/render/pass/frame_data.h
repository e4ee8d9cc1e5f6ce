// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <glm/vec4.hpp>

#include "render/gpu/instance_buffer.h"
#include "render/gpu/uniform_buffer.h"
#include "render/gpu/uniform_pool.h"
#include "render/pass/lobe_store.h"
#include "render/pass/pass.h"
#include "render/pass/table_store.h"
#include "render/plan/frame_plan.h"

namespace patina {

/// Holds what the programs of a frame read: uniform blocks, instances and tables, each written to
/// the GPU only where it changed.
class FrameData : public Pass {
  public:
    /// Serves the frames of `gpu`, which holds it.
    explicit FrameData(FrameGpu& gpu);

    /// Orders what is drawn, and finds or writes what does not depend on the scene's own values.
    Result<bool> prepare(FramePlan& plan, FrameGpu& gpu) override;

    /// Call it before a step draws objects: nothing is known of what programs are in use.
    void bind();

    /// Feeds the surfaces of a batch, whose program is in use then.
    void feed(const FramePlan& plan, const DrawBatch& batch);

    /// Feeds the lines of a batch.
    void feedLines(const FramePlan& plan, const DrawBatch& batch);

    /// Feeds the lights of a list and what else is around objects.
    void feedScene(const FramePlan& plan, const Pipeline& pipeline, std::size_t lights);

    /// Another program has come into use than that of the last batch.
    void forgetProgram() { fedMaterial_.reset(); }

    const InstanceBuffer& instances() const { return instances_; }

    /// Lights of this frame for which there was no room.
    int lostLights() const { return lostLights_; }

  private:
    void makeRoomForLights(std::size_t lists);
    void writeView(const FramePlan& plan, double pixelWidth);
    void placeMaterials(FramePlan& plan);
    void fillTables(const FramePlan& plan);
    void fitLobes(const FramePlan& plan);
    void feedMaterial(const FramePlan& plan, const DrawMaterial& material);
    void note(bool isWritten);

    FrameGpu& gpu_;
    UniformBuffer view_;
    std::vector<UniformBuffer> scenes_;      ///< by list of lights
    std::vector<const Pipeline*> fedScenes_; ///< by list: who reads what is in it now
    UniformPool materials_;
    std::optional<std::size_t> fedMaterial_;
    TableStore tables_;           ///< by material
    LobeStore lobes_;             ///< by material
    InstanceBuffer instances_;    ///< in the list's order
    glm::vec4 pixelInClip_{0.0f}; ///< see OutlineLayout::line
    int lostLights_ = 0;
};

} // namespace patina
