// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/data_layout.h"

#include "scene/transparency.h"

namespace patina {
namespace {

/// The place of a block at `next`, which moves behind it.
std::optional<BlockPlace> placed(const BlockUse& use, const Catalog& catalog, int& next) {
    const Block* block = catalog.find(use.kind, use.id);
    if (block == nullptr) {
        return std::nullopt;
    }
    BlockPlace place{block, layoutOf(*block), next};
    next += place.vec4s();
    return place;
}

/// The tables of everything whose values are placed.
void addTables(ObjectLayout& layout, const EffectSet& set) {
    if (layout.model) {
        layout.tables.add(*layout.model, *set.model, TableReader::Model);
    }
    for (std::size_t i = 0; i < layout.slots.size(); ++i) {
        layout.tables.add(layout.slots[i], set.slots[i], TableReader::Slot);
    }
    if (layout.blend) {
        layout.tables.add(*layout.blend, *set.blend, TableReader::Blend);
    }
}

} // namespace

int LightPlace::vec4s() const {
    return light.vec4s() + (shadow ? shadow->vec4s() + ShadowLayout::vec4s : 0);
}

bool ObjectLayout::isPeeled() const {
    return transparency && layersParameter(*transparency->block) != nullptr;
}

ObjectLayout objectLayout(const EffectSet& set, const Catalog& catalog) {
    ObjectLayout layout;
    if (set.model) {
        layout.model = placed(*set.model, catalog, layout.vec4s);
    }
    for (const BlockUse& use : set.slots) {
        if (auto slot = placed(use, catalog, layout.vec4s)) {
            layout.slots.push_back(std::move(*slot));
        }
    }
    if (set.blend) {
        layout.blend = placed(*set.blend, catalog, layout.vec4s);
    }
    addTables(layout, set);
    layout.firstTexture = layout.vec4s;
    layout.vec4s = layout.texture(set.textures.size());
    if (set.refraction) {
        layout.refraction = placed(*set.refraction, catalog, layout.vec4s);
        layout.vec4s += layout.refraction ? 1 : 0;
    }
    if (set.scene.transparency && isVisiblyTransparent(set) && !set.refraction) {
        layout.transparency = placed(*set.scene.transparency, catalog, layout.vec4s);
        layout.vec4s += layout.transparency ? 1 : 0;
    }
    if (set.ground != GroundMode::Off) {
        layout.ground = layout.vec4s;
        layout.vec4s += set.scene.environment ? 3 : 2;
    }
    return layout;
}

SceneLayout sceneLayout(const SceneEffects& effects, const Catalog& catalog) {
    SceneLayout layout;
    if (effects.fog) {
        layout.fog = placed(*effects.fog, catalog, layout.firstLight);
    }
    if (effects.hemisphere) {
        layout.hemisphere = layout.firstLight;
        layout.firstLight += 3;
    }
    for (const LightGroup& group : effects.lights) {
        if (const Block* block = catalog.find(group.block.kind, group.block.id)) {
            LightPlace place{{block, layoutOf(*block), layout.firstLight++}, std::nullopt};
            if (group.shadow) {
                int behind = place.light.vec4s();
                place.shadow = placed(*group.shadow, catalog, behind);
            }
            layout.groups.push_back(std::move(place));
        }
    }
    if (effects.environment) {
        layout.environment =
            catalog.find(effects.environment->kind, effects.environment->id);
    }
    return layout;
}

} // namespace patina
