// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "shading/effects/effect_set.h"

namespace patina {

/// Represents an effect in the listing that the editor's panel and `patina effects` show.
struct EffectRow {
    EffectLine line;
    bool in = true;           ///< in the program or the pass behind it
    bool removable = false;   ///< withoutEffects() leaves it out
    std::string within;       ///< the effect that takes this one along when it is left out
    bool isOfPicture = false; ///< of the whole picture, so in it without the object, too

    friend bool operator==(const EffectRow&, const EffectRow&) = default;
};

/// Returns what one object of the scene is drawn with, then what is left out and why.
std::vector<EffectRow> effectRows(const Scene& scene, std::size_t object, const Catalog& catalog,
                                  const EffectView& view = {});

/// Returns the scene without some effects, by the names of EffectLine::effect, on every object:
/// what a view shows while they are switched off, and what their cost is measured against. A name
/// that means nothing changes nothing.
Scene withoutEffects(Scene scene, std::span<const std::string> effects, const Catalog& catalog);

} // namespace patina
