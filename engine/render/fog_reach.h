// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "catalog/catalog.h"
#include "core/mesh.h"
#include "render/frustum.h"
#include "scene/scene.h"
#include "shading/effect_view.h"
#include "shading/fog_depth.h"

namespace patina {

/// Whether rays from the eye to what is drawn may meet the box that a scene's fog fills. Where
/// nobody knows they do.
class FogReach {
  public:
    /// The eight corners of a box, numbered as by cornerOf().
    using Corners = std::array<glm::dvec3, 8>;

    /// `eye` is in world space.
    FogReach(const Scene& scene, const Catalog& catalog, const glm::dvec3& eye);

    /// Whether there is a box, so that what is drawn matters.
    bool hasBox() const { return box_.has_value(); }

    /// Adds a box of world space, which need not stand along its axes. Of more than `most` the rest
    /// counts as met. Allocates nothing.
    void add(const Corners& corners);
    void add(const Bounds& bounds, const glm::dmat4& world);
    static constexpr int most = 1000;

    /// No ray to what was added meets the box.
    bool misses() const { return box_ && !isMet_; }

  private:
    bool meets(const Corners& corners) const;

    std::optional<FogBox> box_;
    glm::dvec3 eye_;
    int count_ = 0;
    bool isMet_ = false;
};

/// What depths and fog say to the choice of effects.
EffectView effectView(const DepthRange& depths, const FogReach& fog);

} // namespace patina
