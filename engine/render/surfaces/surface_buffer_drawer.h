// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/lights/environment_light.h"
#include "render/surfaces/surface_buffer.h"
#include "render/surfaces/surface_items.h"

namespace patina {

/// Draws the inputs of shading into a SurfaceBuffer.
class SurfaceBufferDrawer {
  public:
    /// Keeps a reference to `shared`, which must outlive it.
    explicit SurfaceBufferDrawer(RenderResources& shared);

    /// Reads the inputs of a frame's programs for each pixel, with one sample per pixel and all
    /// objects opaque, without the ground. Of an environment it has the directions of round
    /// `round`, as a frame samples them that has too few samples for the model's lobe.
    Result<SurfaceBuffer> capture(const Scene& scene, const View& view, const MeshSource& meshes,
                                  int round = 0);

    /// Is the most directions of an environment, in whole rounds, that such a frame may sample.
    static constexpr int plainSamples = 12;

  private:
    void followCatalog();
    void describe(SurfaceBuffer& buffer, const Scene& scene);
    void drawWindow(const Scene& scene, int firstValue);

    RenderResources& shared_;
    std::shared_ptr<const Catalog> catalog_; ///< is the catalogue that all below is made from
    SurfaceItems items_;
    EnvironmentLight environment_;
};

} // namespace patina
