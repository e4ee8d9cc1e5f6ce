// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Adds what highlights in the model's slots make of ambient light, by a colour of their own.
struct HighlightAmbientEffect {
    static constexpr bool isKnownToReference = true;

    bool highlightAmbient = false;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(highlightAmbient); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {"highlight-ambient", {}, "No highlight has an ambient colour."};
    }
    void place(ObjectLayout& layout, const EffectSet& set) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const HighlightAmbientEffect&, const HighlightAmbientEffect&) = default;
};

/// Returns the vec4 that has the colour; nothing where no highlight has one.
std::optional<int> highlightAmbientData(const ObjectLayout& layout);

} // namespace patina
