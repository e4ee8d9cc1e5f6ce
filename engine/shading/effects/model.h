// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds the material's lighting model. Without one a plain fallback is drawn.
struct ModelEffect {
    static constexpr bool isKnownToReference = true;

    std::optional<BlockUse> model;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void adjust(const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(model); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    void place(ObjectLayout& layout, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    std::string_view whyPerPixel(const EffectSet& set) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const ModelEffect&, const ModelEffect&) = default;
};

/// Declares the model and what fills its slots, and reads its values into `model`.
void writeModel(SurfaceText& text);

/// Tells whether the model is asked for light that arrives from behind.
bool isLitFromBehind(const SurfaceText& text);

} // namespace patina
