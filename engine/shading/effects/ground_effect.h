// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds the scene's ground, drawn in place of a model.
struct GroundEffect {
    GroundMode ground = GroundMode::Off;

    void choose(const SceneSubject& subject, const EffectSet& set);
    void adjust(const EffectSet& set);
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    void place(ObjectLayout& layout, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const GroundEffect&, const GroundEffect&) = default;
};

} // namespace patina
