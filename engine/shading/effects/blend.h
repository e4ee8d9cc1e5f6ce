// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds the material's Fresnel term where its model calls none: the summed light is blended
/// towards its tint.
struct BlendEffect {
    static constexpr bool isKnownToReference = true;

    std::optional<BlockUse> blend;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use) { admitTo(blend, kinds::fresnel, use); }
    void adjust(const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(blend); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::fresnel), {}, "The material has no Fresnel term."};
    }
    void place(ObjectLayout& layout, const EffectSet& set) const;
    void write(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const BlendEffect&, const BlendEffect&) = default;
};

} // namespace patina
