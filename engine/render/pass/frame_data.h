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
#include "render/plan/prepared_frame.h"

namespace patina {

/// Holds the data that the programs of a frame read: uniform blocks, instances and tables. Each is
/// written to the GPU only where it changed.
class FrameData : public Pass {
  public:
    /// Keeps a reference to `gpu`, which owns this object.
    explicit FrameData(FrameGpu& gpu);

    /// Orders the batches, uploads the view and the instances, places the materials' blocks, and
    /// fills tables that changed.
    Result<bool> prepare(PreparedFrame& frame, FrameGpu& gpu) override;

    /// Begins a step that draws objects: it binds the view's block and assumes no other block or
    /// program to be in use.
    void bind();

    /// Binds all data for the surfaces of a batch and makes their program current.
    void feed(const PreparedFrame& frame, const DrawBatch& batch);

    /// Does the same for the outlines of a batch, which must have some.
    void feedLines(const PreparedFrame& frame, const DrawBatch& batch);

    /// Binds the scene's block with the lights of list `lights` for a pipeline.
    void feedScene(const FramePlan& plan, const Pipeline& pipeline, std::size_t lights);

    /// Must be called after another program than that of the last batch was made current.
    void forgetProgram() { fedMaterial_.reset(); }

    const InstanceBuffer& instances() const { return instances_; }

    /// Returns how many lights of this frame did not fit into the scene's block.
    int lostLights() const { return lostLights_; }

  private:
    void makeRoomForLights(std::size_t lists);
    void writeView(const FramePlan& plan, double pixelWidth);
    void placeMaterials(PreparedFrame& frame);
    void fillTables(const PreparedFrame& frame);
    void fitLobes(const PreparedFrame& frame);
    /// Returns the table that was bound; null where the model has none.
    SharedTable bindMeasured(const Pipeline& pipeline, const Material& material);
    void feedMaterial(const PreparedFrame& frame, std::size_t number);
    void note(bool isWritten);

    FrameGpu& gpu_;
    UniformBuffer view_;
    std::vector<UniformBuffer> scenes_;      ///< has one for each list of lights
    std::vector<const Pipeline*> fedScenes_; ///< has for each list the pipeline that its content
                                             ///< was packed for; null when unknown
    UniformPool materials_;
    std::optional<std::size_t> fedMaterial_;
    TableStore tables_;           ///< has one entry for each material
    LobeStore lobes_;             ///< has one entry for each material
    InstanceBuffer instances_;    ///< has the order of DrawList::items()
    glm::vec4 pixelInClip_{0.0f}; ///< is OutlineLayout::line
    int lostLights_ = 0;
};

} // namespace patina
