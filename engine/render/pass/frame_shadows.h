// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "render/pass/shadow_map_pool.h"

namespace patina {

/// Holds what casts shadows in the frames of one view, how the maps of its lights see it, and the
/// maps while a frame draws with them, which the pool lends.
class FrameShadows {
  public:
    /// Keeps a reference to `pool`, which must outlive it.
    explicit FrameShadows(ShadowMapPool& pool) : pool_(pool) {}
    FrameShadows(const FrameShadows&) = delete;
    FrameShadows& operator=(const FrameShadows&) = delete;
    ~FrameShadows() { giveBack(); }

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Begins a frame. Casters are added next, then plan() is called.
    void begin();
    void addCaster(const GpuMesh& mesh, const CasterBox& box, const Material& material) {
        casters_.add(mesh, box, material);
    }

    /// Decides which maps the scene's lights need, and borrows them if they are to be had. The
    /// lights of `effects` decide whether there are shadows, those of `scene` where they fall.
    /// After an error, which says why no map can be drawn, everything is lit.
    Result<void> plan(const Scene& scene, const Scene& effects, const glm::dmat4& cameraToWorld,
                      ProgramCache& programs, const GpuTextureStore& textures);

    /// Tells the pool that somebody goes on with the frame.
    void noteStep();

    /// Makes sure that the frame has its maps, which other frames may have taken. Returns false
    /// while it must wait for them; never if `mustHave`. The error is that of plan().
    Result<bool> hold(bool mustHave, ProgramCache& programs);

    /// Gives the maps back when the frame is done.
    void giveBack();

    /// Returns true when images were made for the last plan().
    bool hasNewImages() const { return hasNewImages_; }

    /// Returns how many maps (faces) must still be drawn; pendingTriangles() is their number of
    /// triangles.
    int pending() const;
    std::int64_t pendingTriangles() const { return casters_.triangles() * pending(); }

    /// Draws about `triangles` triangles of the pending maps. All meshes must be complete.
    void drawSome(int triangles, FrameTextures& textures);

    /// Returns the view of each light.
    std::span<const ShadowView> views() const { return views_.all(); }

    /// Returns how many lights have no map because layers are used up.
    int lost() const { return views_.lost(); }

    void bind() const;

  private:
    Result<bool> borrow(bool mustHave, ProgramCache& programs);

    ShadowMapPool& pool_;
    std::shared_ptr<const Catalog> catalog_;
    ShadowCasters casters_;
    ShadowViews views_;
    std::shared_ptr<ShadowMaps> maps_; ///< are those of this frame or the last one
    bool isBorrowing_ = false;
    bool hasNewImages_ = false;
};

} // namespace patina
