// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Assigns the layers of the shadow maps to lights, and knows which layers are drawn.
class ShadowLayers {
  public:
    struct Layer {
        ShadowView view;
        int face = 0;
        bool isDrawn = false;
    };

    /// Finds a view for each light and layers for its faces. Returns the texels per side of the
    /// maps: `maxTexels`, or fewer where the layers would need too much memory.
    int place(const ShadowedScene& shown, int maxTexels);

    /// Returns how many layers the views need.
    int needed() const;

    /// Makes a layer for each face. Layers that show the same as before stay drawn, unless
    /// `allAnew`. Returns true when some layer changed.
    bool plan(bool allAnew);

    /// Forgets all layers, so that they must be drawn again.
    void forget() { layers_.clear(); }
    void clearViews() { views_.clear(); }

    std::span<Layer> layers() { return layers_; }
    int pending() const;
    std::span<const ShadowView> views() const { return views_; }
    int lost() const {
        return lost_;
    } ///< counts the lights that have no map because layers are
      ///< used up

  private:
    void makeViews(const ShadowedScene& shown, int texels);
    void placeFaces();

    std::vector<ShadowView> views_; ///< has one for each light
    std::vector<Layer> layers_;
    int lost_ = 0;
};

} // namespace patina
