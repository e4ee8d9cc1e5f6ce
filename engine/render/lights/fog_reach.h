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
/// and how much of fog that gets thinner with height. Where nobody knows they meet all of it.
class FogReach {
  public:
    /// Holds the eight corners of a box, numbered as by cornerOf().
    using Corners = std::array<glm::dvec3, 8>;

    /// `eye` is in world space.
    FogReach(const Scene& scene, const Catalog& catalog, const glm::dvec3& eye);

    /// Tells whether it matters what is drawn.
    bool asks() const { return box_ || layer_; }

    /// Adds a box of world space, which need not stand along its axes. Of more than `most` the rest
    /// counts as met. Allocates nothing.
    void add(const Corners& corners);
    void add(const Bounds& bounds, const glm::dmat4& world);
    static constexpr int maxCount = 1000;

    /// No ray to what was added meets the box.
    bool misses() const { return box_ && !isMet_; }

    /// See EffectView::fogThickness.
    double thickness() const;

  private:
    bool meets(const Corners& corners) const;

    void addHeights(const Corners& corners);

    std::optional<FogBox> box_;
    std::optional<FogLayer> layer_;
    glm::dvec3 eye_;
    int count_ = 0;
    bool isMet_ = false;
    double lowest_ = std::numeric_limits<double>::infinity(); ///< what is drawn
};

/// Returns what depths and fog say to the choice of effects.
EffectView effectView(const DepthRange& depths, const FogReach& fog);

} // namespace patina
