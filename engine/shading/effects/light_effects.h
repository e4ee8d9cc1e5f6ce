// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "shading/effects/effect_set.h"

namespace patina {

/// What people call a light: by its name, or by its number where it has none.
std::string lightName(const Scene& scene, std::size_t index);

/// The scene's lights and their shadows, in groups; those that are not in the program are named
/// with the reason, but for those that do not reach what is drawn.
void addLights(SceneEffects& effects, const Scene& scene, const Catalog& catalog,
               const EffectView& view);

/// The scene's ground, in the set of its own program; its lights are there already.
void addGround(EffectSet& set, const Scene& scene);

} // namespace patina
