// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_set.h"

namespace patina {

/// Adds the material's images to a set that has its model, and says which are left out and why.
void addTextures(EffectSet& set, const Material& material, const Catalog& catalog);

/// How one image of the material is used, which has an effect.
TextureEffect textureEffect(const std::string& id, const TextureUse& use, const Material& material,
                            const Catalog& catalog);

EffectLine lineOf(const TextureEffect& texture);

} // namespace patina
