// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "render/pass/shadow_casters.h"
#include "render/pass/shadow_drawer.h"
#include "render/pass/shadow_layers.h"

namespace patina {

/// Owns the shadow maps of the lights. A map is drawn again only when its light or a caster has
/// changed. Drawing can be done in steps.
class ShadowMaps {
  public:
    /// Limits the texels of a map per side, a power of two.
    void setMaxTexels(int texels) { maxTexels_ = texels; }

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Begins a frame. Casters are added next, then plan() is called.
    void clearCasters();
    void addCaster(const GpuMesh& mesh, const CasterBox& box, const Material& material) {
        casters_.add(mesh, box, material);
    }

    /// Decides which maps the scene's lights need and which of them must be drawn. The lights of
    /// `effects` decide whether there are shadows, those of `scene` where they fall. After an
    /// error, which says why no map can be drawn, everything is lit.
    Result<void> plan(const Scene& scene, const Scene& effects, const glm::dmat4& cameraToWorld,
                      ProgramCache& programs, const GpuTextureStore& textures);

    /// Returns how often plan() was called. A view whose number differs knows that another view has
    /// planned since.
    std::uint64_t planNumber() const { return planNumber_; }

    /// Returns true when the maps of the last plan() differ from those before; then drawing of an
    /// incomplete map starts again.
    bool isAnother() const { return isAnother_; }

    /// Returns true when the last plan() allocated the maps.
    bool hasNewImages() const { return hasNewImages_; }

    /// Returns how many maps (faces) must still be drawn; pendingTriangles() is their number of
    /// triangles.
    int pending() const { return layers_.needed() == 0 ? 0 : layers_.pending(); }
    std::int64_t pendingTriangles() const { return casters_.triangles() * pending(); }
    /// Draws about `triangles` triangles of the pending maps. All meshes must be complete.
    void drawSome(int triangles, FrameTextures& textures);

    /// Returns the view of each light.
    std::span<const ShadowView> views() const { return layers_.views(); }
    /// Returns how many lights have no map because layers are used up.
    int lost() const { return layers_.lost(); }
    void bind() const;

  private:
    Result<void> prepare(ProgramCache& programs, const GpuTextureStore& textures, int texels);
    Result<void> makeTexture(int texels, int layers);

    int maxTexels_ = 0;
    std::shared_ptr<const Catalog> catalog_;
    gl::TextureArray texture_;
    ShadowCasters casters_;
    ShadowLayers layers_;
    ShadowDrawer drawer_;
    std::uint64_t planNumber_ = 0;
    int unneeded_ = 0; ///< counts consecutive plans without a map
    bool hasNewImages_ = false;
    bool isAnother_ = false;
};

} // namespace patina
