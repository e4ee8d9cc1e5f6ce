// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/data_layout.h"

#include <algorithm>

#include "scene/transparency.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/light_colors.h"

namespace patina {

const BlockPlace* PartPlaces::part(std::string_view kind) const {
    const auto found = std::ranges::find(
        parts, kind, [](const BlockPlace& place) { return std::string_view(place.block->kind); });
    return found == parts.end() ? nullptr : &*found;
}

int LightPlace::vec4s() const {
    return light.vec4s() + (shadow ? shadow->vec4s() + ShadowLayout::vec4s : 0) +
           (colors > 0 ? lightColorVec4s : 0);
}

bool ObjectLayout::isPeeled() const {
    return transparency && layersParameter(*transparency->block) != nullptr;
}

BlockPlace placed(const BlockUse& use, int& next) {
    BlockPlace place{&use.block(), layoutOf(use.block()), next};
    next += place.vec4s();
    return place;
}

ObjectLayout objectLayout(const EffectSet& set) {
    ObjectLayout layout;
    set.each([&](const auto& effect) {
        if constexpr (requires { effect.place(layout, set); }) {
            effect.place(layout, set);
        }
    });
    return layout;
}

SceneLayout sceneLayout(const EffectSet& set) {
    SceneLayout layout;
    set.eachBackwards([&](const auto& effect) {
        if constexpr (requires { effect.place(layout, set); }) {
            effect.place(layout, set);
        }
    });
    return layout;
}

} // namespace patina
