// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/image.h"
#include "gl/vertex_array.h"
#include "render/gpu/hdr_target.h"
#include "render/surfaces/albedo_table.h"
#include "render/surfaces/inspected_view.h"
#include "render/surfaces/pixel_probe.h"
#include "render/surfaces/probe_target.h"
#include "render/surfaces/surface_items.h"

namespace patina {

/// Draws scenes as the numerical check shows them, and reads the numbers of single pixels. All
/// objects are drawn opaque and with one sample per pixel, so that nothing is averaged.
class InspectionDrawer {
  public:
    /// Keeps a reference to `shared`, which must outlive it.
    explicit InspectionDrawer(RenderResources& shared);

    /// Draws the frame with another thing in place of its light; the numbers: in muted grey, with
    /// patterns where a number is not finite, where one is negative before it is clamped, or where
    /// the surface sends out more light than arrives. An error is in the report's messages.
    const FrameReport& draw(const Scene& scene, const View& view, const MeshSource& meshes,
                            unsigned framebuffer, const Inspected& shown = {});

    /// Returns the same frame: if `display` as draw() shows it, else as it is stored: of the
    /// numbers the linear luminance in red and PixelDefect in green, else the thing itself.
    Result<Image> capture(const Scene& scene, const View& view, const MeshSource& meshes,
                          bool display, const Inspected& shown = {});

    /// Returns the numbers of a pixel, which is (0, 0) at the top left; nothing where there is no
    /// object.
    Result<std::optional<PixelProbe>> probe(const Scene& scene, const View& view,
                                            const MeshSource& meshes, glm::ivec2 pixel);

    const FrameReport& report() const { return items_.report(); }

  private:
    using Item = SurfaceItems::Item;

    void followCatalog();
    Result<void> drawLinear(const Scene& scene, const View& view, const MeshSource& meshes,
                            const Inspected& shown);
    void show(const Scene& scene, const View& view, unsigned framebuffer, const Inspected& shown);
    Result<void> makeDisplays();
    Result<void> prepare(const Scene& scene, const View& view, const MeshSource& meshes);
    void fillAlbedo(const Material& material, const Item& item);
    void drawItems(const Scene& scene, int firstTerm, const Inspected& shown = {});
    PixelProbe read(const Scene& scene, const Item& item, const ProbeTarget::Outputs& outputs);
    void readLights(const Scene& scene, const View& view, glm::ivec2 pixel, PixelProbe& probe);

    RenderResources& shared_;
    std::shared_ptr<const Catalog> catalog_; ///< is the catalogue that all below is made from
    SurfaceItems items_;
    PipelineStore tables_;
    std::vector<AlbedoTable> albedos_; ///< has one for each object
    HdrTarget target_;
    std::optional<ProbeTarget> probeTarget_;
    gl::VertexArray noVertices_ = gl::VertexArray::create();
    std::shared_ptr<const gl::Program> display_;     ///< shows the numbers
    std::shared_ptr<const gl::Program> viewDisplay_; ///< shows all else
};

} // namespace patina
