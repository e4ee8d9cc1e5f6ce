// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "shading/effects/effect_set.h"

namespace patina {

/// What the scene's picture accuracy changes in programs. Fog at vertices counts with fog only.
void addPictureEffects(SceneEffects& effects, const Scene& scene);

/// A number that tells apart what addPictureEffects() does; `hasFog`: fog is in the effects.
std::uint64_t pictureEffectsKey(const Scene& scene, bool hasFog);

/// Whether the set's light is worked out at vertices, its normals stay as they are blended and its
/// highlights are widened, and why not where the scene wants it so.
void addPictureWork(EffectSet& set, const Catalog& catalog);

/// Whether a model draws marks on the picture, which is known by a parameter in pixels.
bool drawsMarks(const Block& model);

} // namespace patina
