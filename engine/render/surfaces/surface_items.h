// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "render/gpu/uniform_buffer.h"
#include "render/lights/fog_reach.h"
#include "render/lights/frustum.h"
#include "render/pass/frame_shadows.h"
#include "render/pass/render_resources.h"
#include "render/view.h"
#include "shading/effects/effect_key.h"
#include "shading/program/parameter_packer.h"

namespace patina {

/// Draws the objects of a frame for numbers instead of a picture: each by itself and opaque, with
/// programs of one SurfaceOutput, into any target.
class SurfaceItems {
  public:
    /// Is an object that is drawn, with the data for its program.
    struct Item {
        std::size_t index = 0; ///< is the object's index in the scene
        const GpuMesh* mesh = nullptr;
        Bounds bounds;
        glm::dmat4 world{1.0};
        UniformBuffer* data = nullptr;
        std::shared_ptr<const Pipeline> pipeline; ///< is null when no program could be compiled
        bool isNew = false;                       ///< says that its data differ from those of the
                                                  ///< last frame
    };

    /// Keeps a reference to `shared`, which must outlive it.
    SurfaceItems(RenderResources& shared, SurfaceOutput output);

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Collects the objects, makes their programs, draws the shadow maps and uploads all data. If
    /// `usesDepths`, the effects are those of the picture; else fog is never left out for being
    /// invisible. Errors are in the report's messages.
    void prepare(const Scene& scene, const View& view, const MeshSource& meshes, bool usesDepths);

    /// Draws all objects into the bound framebuffer. `begin` is called for each object while its
    /// program is in use.
    void draw(const Scene& scene, const std::function<void(const Item&)>& begin);

    /// Binds the table of the measured file that the item's material names, where it has one.
    void bindMeasured(const Material& material, const Item& item);

    /// Ends the frame that prepare() began.
    void end();

    std::span<Item> items() { return items_; }

    /// Returns the content of the scene's block.
    std::span<const glm::vec4> sceneData() { return sceneData_.staging(); }

    PipelineStore& pipelines() { return pipelines_; }
    FrameReport& report() { return report_; }
    const FrameReport& report() const { return report_; }

  private:
    FogReach fogReach(const Scene& scene) const;
    void collect(const Scene& scene, const View& view, const MeshSource& meshes);
    void choosePipelines(const Scene& scene, const EffectView& view);
    void note(const PipelineStore::Entry& entry);
    void drawShadows(const Scene& scene);
    void feed(const Scene& scene, const View& view);
    void feedMaterial(const Material& material, Item& item);
    void bindImages(const Material& material, const Item& item);

    std::shared_ptr<const Catalog> catalog_;
    PipelineStore pipelines_;
    RenderResources& shared_;
    FrameTextures textures_;
    FrameShadows shadows_;
    UniformBuffer viewData_;
    UniformBuffer sceneData_;
    EffectKey keys_;
    std::vector<std::unique_ptr<UniformBuffer>> data_; ///< has one for each object
    std::vector<Item> items_;
    InstanceBuffer instances_; ///< has one for each item
    PackedAround around_{glm::dmat4(1.0)};
    DepthRange depths_;
    FrameReport report_;
};

/// Returns the indices of the scene's lights in the order in which the program adds them; only the
/// key light where the model takes that alone.
std::vector<std::size_t> lightsInOrder(const Scene& scene, const Pipeline& pipeline);

} // namespace patina
