// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"
#include "shading/effects/effect_view.h"
#include "shading/effects/light_lines.h"

namespace patina {

/// Numbers that are equal when the effect sets are, made without any allocation: what tells a
/// frame whether the programs of the last one still fit.
class EffectKey {
  public:
    /// Hashes sceneEffects(scene, catalog, view), without the counts of lights that loops go
    /// through.
    std::uint64_t ofScene(const Scene& scene, const Catalog& catalog, const EffectView& view = {});

    /// Hashes what effectSet() adds for the material.
    static std::uint64_t ofMaterial(const Material& material, const Catalog& catalog);

    /// Hashes the scene's environment and its compiled values; 0 when it is left out.
    static std::uint64_t ofEnvironment(const Scene& scene, const Catalog& catalog);

    /// Hashes what happens to the picture behind the objects: equal where one program does it.
    static std::uint64_t ofDisplay(const Scene& scene);

    /// Hashes one light's block and compiled values, and its shadows' where shadows can be seen (as
    /// hasShadows() says); 0 when it is left out.
    static std::uint64_t ofLight(const Light& light, const Catalog& catalog, bool hasShadows);

  private:
    LightLines lines_; ///< kept for its memory
};

} // namespace patina
