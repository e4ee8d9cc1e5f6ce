// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gl/vertex_array.h"
#include "render/gpu/hdr_target.h"
#include "render/surfaces/albedo_table.h"
#include "render/surfaces/pixel_probe.h"
#include "render/surfaces/probe_target.h"
#include "render/surfaces/surface_items.h"

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
    const FrameReport& report() const { return items_.report(); }

  private:
    using Item = SurfaceItems::Item;

    Result<void> prepare(const Scene& scene, const View& view, const MeshSource& meshes);
    void fillAlbedo(const Material& material, const Item& item);
    void drawItems(const Scene& scene, int firstTerm);
    PixelProbe read(const Scene& scene, const Item& item, const ProbeTarget::Outputs& outputs);
    void readLights(const Scene& scene, const View& view, glm::ivec2 pixel, PixelProbe& probe);

    std::shared_ptr<const Catalog> catalog_;
    SurfaceItems items_;
    PipelineStore tables_;
    std::vector<AlbedoTable> albedos_; ///< by object
    HdrTarget target_;
    std::optional<ProbeTarget> probeTarget_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> display_;
};

} // namespace patina
