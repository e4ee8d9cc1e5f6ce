// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shading/effects/effect_set.h"

namespace patina {

/// Hashes of choices, made without any allocation: what tells a frame whether the programs of the
/// last one still fit. Sets are equal where both of their hashes are, and differ where one does.
class EffectKey {
  public:
    /// Hashes what the scene brings into all programs: sceneEffects(scene, catalog, view).
    std::uint64_t ofScene(const Scene& scene, const Catalog& catalog, const EffectView& view = {});

    /// Hashes what effectSet() chooses for the material.
    static std::uint64_t ofMaterial(const Material& material, const Catalog& catalog);

    /// Hashes the scene's environment; 0 when it is left out.
    static std::uint64_t ofEnvironment(const Scene& scene, const Catalog& catalog);

    /// Hashes what happens to the picture behind the objects: equal where one program does it.
    static std::uint64_t ofDisplay(const Scene& scene, const Catalog& catalog);

    /// Hashes one light's block and compiled values, and its shadows' where shadows can be seen (as
    /// hasShadows() says); 0 when it is left out.
    static std::uint64_t ofLight(const Light& light, const Catalog& catalog, bool hasShadows);

  private:
    EffectSet set_; ///< kept for its memory
};

} // namespace patina
