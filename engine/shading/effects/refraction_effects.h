// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_set.h"

namespace patina {

/// Adds what bends the light that the material lets through, or why nothing does. The set's scene
/// has been filled.
void addRefraction(EffectSet& set, const Material& material, const Scene& scene,
                   const Catalog& catalog);

} // namespace patina
