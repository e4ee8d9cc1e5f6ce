// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "render/surface_buffer.h"
#include "render/surface_items.h"

namespace patina {

/// Draws what surfaces are shaded from.
class SurfaceBufferDrawer {
  public:
    /// `meshes`, `textures` and `shadows` outlive it.
    SurfaceBufferDrawer(std::filesystem::path programCache, GpuMeshStore& meshes,
                        GpuTextureStore& textures, ShadowMaps& shadows);

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    Result<SurfaceBuffer> capture(const Scene& scene, const View& view, const MeshSource& meshes);

  private:
    void describe(SurfaceBuffer& buffer, const Scene& scene);
    void drawWindow(const Scene& scene, int firstValue);

    bool hasCatalog_ = false;
    SurfaceItems items_;
};

} // namespace patina
