// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/lights/environment_light.h"
#include "render/surfaces/surface_buffer.h"
#include "render/surfaces/surface_items.h"

namespace patina {

/// Draws what surfaces are shaded from.
class SurfaceBufferDrawer {
  public:
    /// `shared` outlives it.
    explicit SurfaceBufferDrawer(RenderResources& shared);

    /// Reads what the programs of a frame have for each pixel, with one sample per pixel and all
    /// objects drawn as opaque ones, without the ground. Of an environment it has this round of
    /// directions, as frames draw them that are too short to look for the model's lobe.
    Result<SurfaceBuffer> capture(const Scene& scene, const View& view, const MeshSource& meshes,
                                  int round = 0);

    /// The most directions of an environment that such a frame may draw: whole rounds.
    static constexpr int plainSamples = 12;

  private:
    void followCatalog();
    void describe(SurfaceBuffer& buffer, const Scene& scene);
    void drawWindow(const Scene& scene, int firstValue);

    RenderResources& shared_;
    std::shared_ptr<const Catalog> catalog_; ///< the one that all below is made from
    SurfaceItems items_;
    EnvironmentLight environment_;
};

} // namespace patina
