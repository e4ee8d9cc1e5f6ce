// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/lights/shadow_view.h"
#include "scene/scene.h"

namespace patina {

/// Names the lights of a frame and the casters. The lights of `effects` decide whether there are
/// shadows, those of `scene` where they fall.
struct ShadowedScene {
    const Scene& scene;
    const Scene& effects;
    const Catalog& catalog;
    const glm::dmat4& cameraToWorld;
    std::span<const CasterBox> casters;
};

/// Limits the shadow maps.
struct ShadowLimits {
    int texels = 0;         ///< per side of a map, a power of two
    std::int64_t bytes = 0; ///< of all maps together
};

/// Holds how the shadow maps of a frame's lights see the scene, and in which layers they lie.
class ShadowViews {
  public:
    /// Finds a view for each light and layers for its faces. Where they would need too much memory
    /// the maps have fewer texels.
    void place(const ShadowedScene& shown, const ShadowLimits& limits);

    /// Leaves no light with a map.
    void clear() { views_.clear(); }

    /// Returns the view of each light.
    std::span<const ShadowView> all() const { return views_; }

    /// Returns how many layers the views need.
    int layers() const;

    /// Returns the texels per side of the maps.
    int texels() const { return texels_; }

    /// Returns the bytes of the maps.
    std::int64_t bytes() const;

    /// Returns how many lights have no map because layers are used up.
    int lost() const { return lost_; }

  private:
    void makeViews(const ShadowedScene& shown);
    void placeFaces(std::int64_t maxBytes);

    std::vector<ShadowView> views_;
    int texels_ = 0;
    int lost_ = 0;
};

} // namespace patina
