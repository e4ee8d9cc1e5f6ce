// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/lights/environment_light.h"
#include "render/surfaces/surface_buffer.h"
#include "render/surfaces/surface_items.h"

namespace patina {

/// Draws what surfaces are shaded from.
class SurfaceBufferDrawer {
  public:
    /// `meshes`, `textures` and `shadows` outlive it.
    SurfaceBufferDrawer(std::filesystem::path programCache, GpuMeshStore& meshes,
                        GpuTextureStore& textures, ShadowMaps& shadows);

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// With a round of directions of the scene's environment.
    Result<SurfaceBuffer> capture(const Scene& scene, const View& view, const MeshSource& meshes,
                                  int round);

  private:
    void describe(SurfaceBuffer& buffer, const Scene& scene);
    void drawWindow(const Scene& scene, int firstValue);

    std::shared_ptr<const Catalog> catalog_;
    SurfaceItems items_;
    EnvironmentLight environment_;
};

} // namespace patina
