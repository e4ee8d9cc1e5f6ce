// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_parts.h"

namespace patina {

/// Returns the share of the light that the material's model itself says to pass, 0 .. 1: by its
/// parameters with the key `transparency`. It is 0 where it has none or is not known.
double saidShare(const Material& material, const Catalog& catalog);

/// Returns the share that is taken to pass, at most 1 - 2^-10: what the surface still gives back is
/// divided by the rest (see ObjectLayout::surface).
double passedShare(const Material& material, const Catalog& catalog);

/// Returns how much of what is behind the material it hides, 0 .. 1: its opacity and its model's
/// share together.
double opacityOf(const Material& material, const Catalog& catalog);

/// Tells whether anything of the material may be there.
bool canBeSeen(const Material& material);

/// Tells whether a frame has anything of the object.
bool isDrawn(const Object& object);

/// Tells whether the material may be transparent: by its opacity, or by an image of it that does
/// not only cut out, or by its model.
bool isTransparent(const Material& material, const Catalog& catalog);

/// The material hides less than everything.
struct OpacityEffect {
    static constexpr bool isKnownToReference = true;

    bool opacity = false;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(opacity); }
    void list(EffectListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {"opacity", {}, "The material's opacity is 1."};
    }
    void writeLight(SurfaceText& text) const;
    void write(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const OpacityEffect&, const OpacityEffect&) = default;
};

} // namespace patina
