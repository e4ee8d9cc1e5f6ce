// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "render/pass/shadow_casters.h"
#include "render/pass/shadow_drawer.h"
#include "render/pass/shadow_layers.h"
#include "render/pass/shadow_views.h"

namespace patina {

/// Says what shadow maps are to show.
struct ShadowWish {
    const ShadowCasters& casters;
    const ShadowViews& views;
    const Catalog& catalog;
    ProgramCache& programs;
};

/// Owns the shadow maps of a set of lights and casters. A map is drawn again only when its light or
/// a caster has changed, and in steps, which frames that want the same may take in turns.
class ShadowMaps {
  public:
    /// Returns true when the maps are of just this, drawn or not.
    bool areOf(const ShadowWish& wish) const;

    /// Returns true when maps of the wish have the same size and number.
    bool haveSizeOf(const ShadowViews& views) const;

    /// Takes over what is wished. Fails when the images or the program cannot be made; then the
    /// maps are good for nothing. Returns whether it made new images.
    Result<bool> plan(const ShadowWish& wish);

    /// Frees the images; they show nothing from then on.
    void release();
    bool areReleased() const { return texture_.name() == 0; }

    /// Returns how many maps (faces) must still be drawn.
    int pending() const { return layers_.pending(); }

    /// Draws about `triangles` triangles of the pending maps. The casters, whose meshes must be
    /// complete, are those of the plan.
    void drawSome(int triangles, ShadowCasters& casters, FrameTextures& textures);

    void bind() const;

    /// Returns the bytes of the images.
    std::int64_t bytes() const;

  private:
    Result<bool> makeTexture(const ShadowViews& views);

    gl::TextureArray texture_;
    ShadowCasters::Record casters_;
    ShadowLayers layers_;
    ShadowDrawer drawer_;
};

} // namespace patina
