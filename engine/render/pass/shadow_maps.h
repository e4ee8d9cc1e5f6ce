// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "render/pass/shadow_casters.h"
#include "render/pass/shadow_drawer.h"
#include "render/pass/shadow_layers.h"

namespace patina {

/// The depth maps of the lights that cast shadows. A map is drawn again only when its light, what
/// casts shadows or where that stands has changed. Drawing goes on in steps where that is wished.
class ShadowMaps {
  public:
    /// The most texels of a map per side, a power of two.
    void setMaxTexels(int texels) { maxTexels_ = texels; }

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Begins a frame: first what casts shadows, then plan().
    void clearCasters();
    void addCaster(const GpuMesh& mesh, const CasterBox& box, const Material& material) {
        casters_.add(mesh, box, material);
    }

    /// Returns which maps the scene's lights need, and which of them must be drawn. The lights of
    /// `effects` say whether there are shadows, those of `scene` where they fall. Without a map, or
    /// where the error says why none can be drawn, everything is lit.
    Result<void> plan(const Scene& scene, const Scene& effects, const glm::dmat4& cameraToWorld,
                      ProgramCache& programs, const GpuTextureStore& textures);

    /// Returns how often plan() was called: another number than one's own says that somebody else's
    /// plan has taken its place.
    std::uint64_t planNumber() const { return planNumber_; }

    /// Tells whether the last plan() has other maps than the one before: what was drawn of a map
    /// that is not whole yet is lost.
    bool isAnother() const { return isAnother_; }

    /// Tells whether the last plan() has made the images of the maps.
    bool hasNewImages() const { return hasNewImages_; }

    /// Maps (faces) that are still to be drawn, and their triangles.
    int pending() const { return layers_.needed() == 0 ? 0 : layers_.pending(); }
    std::int64_t pendingTriangles() const { return casters_.triangles() * pending(); }
    /// Draws about so many triangles of them; their meshes are complete.
    void drawSome(int triangles, FrameTextures& textures);

    /// Returns the view of each light.
    std::span<const ShadowView> views() const { return layers_.views(); }
    /// Lights for whose maps there is no room.
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
    int unneeded_ = 0; ///< plans without a map, one after the other
    bool hasNewImages_ = false;
    bool isAnother_ = false;
};

} // namespace patina
