// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds what refracts the light that a material transmits; a null block: nothing does, and why.
struct RefractionChoice {
    const Block* block = nullptr;
    const Values* values = nullptr;
    const char* whyNot = ""; ///< empty where the material chooses nothing
};

/// A neutral choice is left out: where nothing passes, and where the index is 1 and nothing is
/// coloured. Allocates nothing, unless the index is one that the Fresnel term works out.
RefractionChoice refractionChoice(const Material& material, const Catalog& catalog);

/// Tells whether light leaves it in its old direction: a pane, which has a thickness.
bool isSheet(const Block& refraction);

/// Tells whether it follows rays from facet to facet of a convex body of flat ones: the levels of
/// an accuracy choice are whole numbers, of reflections inside.
bool followsFacets(const Block& refraction);

/// Tells whether an object that is seen refracts what is behind it. Allocates nothing.
bool hasRefraction(const Scene& scene, const Catalog& catalog);

/// Tells whether an object refracts what is behind it and there is something of the scene to be
/// behind it.
bool showsSceneRefracted(const Scene& scene, const Catalog& catalog);

/// Holds what refracts the light that the material transmits.
struct RefractionEffect {
    static constexpr bool isKnownToReference = true;

    std::optional<BlockUse> refraction;
    /// Says that what the surface mirrors is by the material's Fresnel term, whose index does not
    /// tell it.
    bool mirrorsByTerm = false;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void choose(const SceneSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use) { admitTo(refraction, kinds::refraction, use); }
    void addTo(ChoiceHash& hash) const;
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {"refraction", {}, "The material refracts no light."};
    }
    void place(ObjectLayout& layout, const EffectSet& set) const;
    void write(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const RefractionEffect&, const RefractionEffect&) = default;
};

/// Holds what is seen through a body that refracts light: the scene, or only what is far behind it.
struct RefractedSceneEffect {
    bool isShownRefracted = false; ///< see showsSceneRefracted()

    void choose(const SceneSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(isShownRefracted); }

    friend bool operator==(const RefractedSceneEffect&, const RefractedSceneEffect&) = default;
};

} // namespace patina
