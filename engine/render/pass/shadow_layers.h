// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "render/lights/shadow_view.h"
#include "scene/scene.h"

namespace patina {

/// Holds the lights of a frame and what casts shadows in them: those of `effects` say whether there
/// are shadows, those of `scene` where they fall.
struct ShadowedScene {
    const Scene& scene;
    const Scene& effects;
    const Catalog& catalog;
    const glm::dmat4& cameraToWorld;
    std::span<const CasterBox> casters;
};

/// Knows which layer of the depth maps shows what of which light, and whether it is drawn.
class ShadowLayers {
  public:
    struct Layer {
        ShadowView view;
        int face = 0;
        bool isDrawn = false;
    };

    /// Finds a view for each light, and room for its faces. Returns how many texels per side there
    /// is memory for, at most `maxTexels`.
    int place(const ShadowedScene& shown, int maxTexels);

    /// Returns how many layers the views need.
    int needed() const;

    /// Makes a layer of each face; those that show the same as before stay drawn, unless all are to
    /// be drawn anew. Tells whether some show another thing than before.
    bool plan(bool allAnew);

    /// Leaves nothing drawn.
    void forget() { layers_.clear(); }
    void clearViews() { views_.clear(); }

    std::span<Layer> layers() { return layers_; }
    int pending() const;
    std::span<const ShadowView> views() const { return views_; }
    int lost() const { return lost_; } ///< lights for which there is no room

  private:
    void makeViews(const ShadowedScene& shown, int texels);
    void placeFaces();

    std::vector<ShadowView> views_; ///< of each light
    std::vector<Layer> layers_;
    int lost_ = 0;
};

} // namespace patina
