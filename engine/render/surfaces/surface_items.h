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
#include "render/pass/render_resources.h"
#include "render/view.h"
#include "shading/effects/effect_key.h"

namespace patina {

/// Holds the objects of a frame whose numbers are wanted and not its picture: each is drawn by
/// itself and as an opaque one, with programs of one output, whatever the target is.
class SurfaceItems {
  public:
    /// Represents an object that is drawn, and what its program is fed with.
    struct Item {
        std::size_t index = 0; ///< in the scene
        const GpuMesh* mesh = nullptr;
        Bounds bounds;
        glm::dmat4 world{1.0};
        UniformBuffer* data = nullptr;
        std::shared_ptr<const Pipeline> pipeline; ///< null: nothing could be compiled
        bool isNew = false;                       ///< its data are not those of the last frame
    };

    /// `shared` outlives it.
    SurfaceItems(RenderResources& shared, SurfaceOutput output);

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Collects the objects and feeds their programs; shadow maps are drawn. The effects are those
    /// of the picture where `usesDepths`, else no fog is left out because it is not seen.
    void prepare(const Scene& scene, const View& view, const MeshSource& meshes, bool usesDepths);

    /// Draws all of them into what is bound; `begin` is called with each program in use.
    void draw(const Scene& scene, const std::function<void(const Item&)>& begin);

    /// Ends what prepare() began.
    void end();

    std::span<Item> items() { return items_; }

    /// Returns what the scene's block holds.
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

    std::shared_ptr<const Catalog> catalog_;
    PipelineStore pipelines_;
    RenderResources& shared_;
    FrameTextures textures_;
    UniformBuffer viewData_;
    UniformBuffer sceneData_;
    EffectKey keys_;
    std::vector<std::unique_ptr<UniformBuffer>> data_; ///< by object
    std::vector<Item> items_;
    InstanceBuffer instances_; ///< by item
    glm::dmat4 cameraToWorld_{1.0};
    DepthRange depths_;
    FrameReport report_;
};

/// Returns the scene's lights in the order in which the program adds them; of a drawing's the key
/// light.
std::vector<std::size_t> lightsInOrder(const Scene& scene, const Pipeline& pipeline);

} // namespace patina
