// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "catalog/catalog.h"
#include "core/mesh.h"
#include "render/lights/frustum.h"
#include "scene/scene.h"
#include "shading/effects/effect_view.h"
#include "shading/effects/fog.h"

namespace patina {

/// Decides whether rays from the eye to what is drawn may meet the box that a scene's fog fills,
/// and how thick fog that gets thinner with height can be along them. In doubt it assumes the most
/// fog.
class FogReach {
  public:
    /// Has the eight corners of a box in world space, numbered as by cornerOf().
    using Corners = std::array<glm::dvec3, 8>;

    /// Takes the fog of `scene`; `eye` is in world space.
    FogReach(const Scene& scene, const Catalog& catalog, const glm::dvec3& eye);

    /// Returns true when what is drawn matters: the fog has a box or gets thinner with height.
    bool asks() const { return box_ || layer_; }

    /// Adds a box of world space, which may be rotated. Boxes beyond `maxCount` count as met by the
    /// fog. It allocates nothing.
    void add(const Corners& corners);
    void add(const Bounds& bounds, const glm::dmat4& world);
    static constexpr int maxCount = 1000;

    /// Returns true when no ray to what was added meets the box of the fog.
    bool misses() const { return box_ && !isMet_; }

    /// Returns EffectView::fogThickness; 1 when nothing is known.
    double thickness() const;

  private:
    bool meets(const Corners& corners) const;

    void addHeights(const Corners& corners);

    std::optional<FogBox> box_;
    std::optional<FogLayer> layer_;
    glm::dvec3 eye_;
    int count_ = 0;
    bool isMet_ = false;
    double lowest_ = std::numeric_limits<double>::infinity(); ///< is the lowest height of what was
                                                              ///< added
};

/// Returns what the choice of effects needs to know of depths and fog.
EffectView effectView(const DepthRange& depths, const FogReach& fog);

} // namespace patina
