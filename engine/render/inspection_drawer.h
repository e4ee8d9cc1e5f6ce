// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "render/albedo_table.h"
#include "render/frustum.h"
#include "render/gpu_mesh_store.h"
#include "render/gpu_texture_store.h"
#include "render/hdr_target.h"
#include "render/pipeline_store.h"
#include "render/pixel_probe.h"
#include "render/probe_target.h"
#include "render/renderer.h"
#include "render/shadow_maps.h"
#include "render/uniform_buffer.h"
#include "shading/effect_key.h"

namespace patina {

/// Draws scenes as the numerical check shows them, and reads the numbers of single pixels. All
/// objects are drawn as opaque ones and with one sample per pixel, so that nothing is averaged.
class InspectionDrawer {
  public:
    /// `meshes`, `textures` and `shadows` outlive it.
    InspectionDrawer(std::filesystem::path programCache, GpuMeshStore& meshes,
                     GpuTextureStore& textures, ShadowMaps& shadows);

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Into the linear target: red is the luminance, green the PixelDefect.
    Result<void> drawLinear(const Scene& scene, const View& view, const MeshSource& meshes);

    /// The linear target into a framebuffer, with patterns for what is wrong.
    void show(const Scene& scene, const View& view, unsigned framebuffer);

    /// The numbers of a pixel, (0, 0) at the top left; nothing where there is no object.
    Result<std::optional<PixelProbe>> probe(const Scene& scene, const View& view,
                                            const MeshSource& meshes, glm::ivec2 pixel);

    unsigned linearFramebuffer() const { return target_.resolvedFramebuffer(); }
    const FrameReport& report() const { return report_; }

  private:
    struct Slot {
        UniformBuffer data;
        AlbedoTable albedo;
        std::shared_ptr<const Pipeline> pipeline; ///< null: nothing could be compiled
    };
    struct Item {
        std::size_t index = 0;
        const GpuMesh* mesh = nullptr;
        Bounds bounds;
        glm::dmat4 world{1.0};
    };

    Result<void> prepare(const Scene& scene, const View& view, const MeshSource& meshes);
    void collect(const Scene& scene, const View& view, const MeshSource& meshes);
    void choosePipelines(const Scene& scene);
    void note(const PipelineStore::Entry& entry);
    void drawShadows(const Scene& scene);
    void feed(const Scene& scene, const View& view);
    void feedMaterial(const Material& material, Slot& slot);
    void drawItems(const Scene& scene, int firstTerm);
    PixelProbe read(const Scene& scene, const Item& item, const ProbeTarget::Outputs& outputs);
    void readLights(const Scene& scene, const View& view, glm::ivec2 pixel, PixelProbe& probe);

    std::shared_ptr<const Catalog> catalog_;
    PipelineStore pipelines_;
    PipelineStore tables_;
    GpuMeshStore& meshes_;
    GpuTextureStore& textures_;
    ShadowMaps& shadows_;
    HdrTarget target_;
    std::optional<ProbeTarget> probeTarget_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> display_;
    UniformBuffer viewData_;
    UniformBuffer sceneData_;
    EffectKey keys_;
    std::vector<Slot> slots_;
    std::vector<Item> items_;
    InstanceBuffer instances_; ///< by item
    glm::dmat4 cameraToWorld_{1.0};
    DepthRange depths_;
    FrameReport report_;
};

} // namespace patina
