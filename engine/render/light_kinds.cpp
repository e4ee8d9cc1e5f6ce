// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/light_kinds.h"

#include <algorithm>

#include "shading/effect_choice.h"
#include "shading/effect_key.h"
#include "shading/effect_view.h"

namespace patina {

void LightKinds::begin(const Scene& effects, const Catalog& catalog) {
    kinds_.clear();
    const bool shadows = hasShadows(effects, catalog);
    for (std::size_t i = 0; i < effects.lights.size(); ++i) {
        const std::uint64_t key = EffectKey::ofLight(effects.lights[i], catalog, shadows);
        if (key == 0) {
            continue;
        }
        auto kind = std::ranges::find(kinds_, key, &Kind::key);
        if (kind == kinds_.end()) {
            kind = kinds_.insert(kind, {key, 0, true});
        }
        if (i < EffectView::knownLights) {
            kind->lights |= std::uint64_t(1) << i;
        } else {
            kind->isKnown = false;
        }
    }
}

std::uint64_t LightKinds::unreached(const LightLists& lists, std::size_t list) const {
    const std::uint64_t missing = lists.unreached(list);
    std::uint64_t lights = 0;
    for (const Kind& kind : kinds_) {
        if (kind.isKnown && (kind.lights & ~missing) == 0) {
            lights |= kind.lights;
        }
    }
    return lights;
}

} // namespace patina
