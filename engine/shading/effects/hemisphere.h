// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Adds ambient light that differs above and below.
struct HemisphereEffect {
    static constexpr bool isKnownToReference = true;

    bool hemisphere = false;

    void choose(const SceneSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(hemisphere); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {"hemisphere", {}, "The light of its sky and its ground is black."};
    }
    void place(SceneLayout& layout, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const HemisphereEffect&, const HemisphereEffect&) = default;
};

/// Returns the first of the three vec4s of its data (the sky, the ground and the unit direction
/// up); nothing where it is not in the program.
std::optional<int> hemisphereData(const SceneLayout& layout);

/// Declares and calls what the sky and the ground of the ambient light send to a surface.
std::string hemisphereLight(SurfaceText& text);

} // namespace patina
