// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"
#include "shading/effects/effect_view.h"

namespace patina {

/// Holds what a material's effects are chosen from. They do not depend on the scene around it.
struct MaterialSubject {
    const Material& material;
    const Catalog& catalog;
};

/// Holds what the effects that a scene brings into all programs are chosen from.
struct SceneSubject {
    const Scene& scene;
    const Catalog& catalog;
    const EffectView& view;
    bool isGround = false; ///< the scene's ground is drawn, in place of a material
};

/// Holds what a set was chosen for, for sentences that say why.
struct EffectSubject {
    const Material* material = nullptr; ///< null: it was chosen for the scene, or its ground
    const Scene& scene;
    const Catalog& catalog;
    const EffectView& view;
};

} // namespace patina
