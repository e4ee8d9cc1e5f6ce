// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_parts.h"

namespace patina {

/// Tells whether the material hides enough to keep light from others: half of it.
bool canShadow(const Material& material, const Catalog& catalog);

/// Tells whether an object keeps light from others: it is drawn, may do so, and lets less than half
/// of the light through.
bool isCaster(const Object& object, const Catalog& catalog);
bool hasCaster(const Scene& scene, const Catalog& catalog);

/// Tells whether a shadow can fall on anything: on the ground, or on an object whose model is
/// known.
bool hasReceiver(const Scene& scene, const Catalog& catalog);

/// Tells whether the scene is one object that is flat: it keeps no light from itself.
bool isLoneFlat(const Scene& scene, const Catalog& catalog);

/// Tells whether shadows can be seen in lights that have some: something casts one, something
/// catches it.
bool hasShadows(const Scene& scene, const Catalog& catalog);

/// Tells whether a light of the set has shadows.
bool hasShadows(const EffectSet& set);

/// Returns the block that draws the shadows in a light of kind `light`; null where it has none.
const Block* shadowBlock(const Light& light, const Block& block, const Catalog& catalog);

/// Shadows in the lights that have some; LightGroup says which.
struct ShadowsEffect {
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::shadows), {}, "No light has shadows."};
    }
    std::string_view whyPerPixel(const EffectSet& set) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const ShadowsEffect&, const ShadowsEffect&) = default;
};

/// Declares what all shadows share, and reads what they need of the surface.
void writeShadowCode(SurfaceText& text);

/// Declares `arriving<index>`: the share of a light of this group that nothing keeps away; 0 where
/// the model asks for none.
void writeShadow(SurfaceText& text, std::size_t index);

} // namespace patina
