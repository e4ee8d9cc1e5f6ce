// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "render/lights/shadow_view.h"

namespace patina {

/// Holds what the layers of shadow maps show, and which of them are drawn.
class ShadowLayers {
  public:
    struct Layer {
        ShadowView view;
        int face = 0;
        bool isDrawn = false;
    };

    /// Makes a layer for each face of the views, which have consecutive ones. Layers that show the
    /// same as before stay drawn, unless `allAnew`. Returns true when some layer changed.
    bool plan(std::span<const ShadowView> views, bool allAnew);

    /// Returns true when plan() would change nothing.
    bool areOf(std::span<const ShadowView> views) const;

    std::span<Layer> layers() { return layers_; }

    /// Returns how many layers must still be drawn.
    int pending() const;

  private:
    std::vector<Layer> layers_;
};

} // namespace patina
