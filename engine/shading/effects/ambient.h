// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_parts.h"

namespace patina {

/// Adds the scene's ambient colour: light from everywhere.
struct AmbientEffect {
    static constexpr bool isKnownToReference = true;

    bool ambient = false;

    void choose(const SceneSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(ambient); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {"ambient", {}, "The scene's ambient colour is black."};
    }
    void writeLight(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const AmbientEffect&, const AmbientEffect&) = default;
};

/// Returns an expression for what the model makes of light from all around.
std::string ambientShare(SurfaceText& text);

/// Returns "0.1, 0.2, 0.3".
std::string colorText(const glm::dvec3& color);

} // namespace patina
