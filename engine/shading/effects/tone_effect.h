// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "shading/effects/effect_parts.h"
#include "shading/program/source_builder.h"

namespace patina {

struct DisplaySet;

/// Holds the tone curve that brings the light of the picture into a display's range.
struct ToneEffect {
    std::optional<BlockUse> tone;

    void choose(const Scene& scene, const Catalog& catalog);
    void addTo(ChoiceHash& hash) const { hash.add(tone); }
    void list(EffectListing& listing, const DisplaySet& set) const;
    void listMissing(LeftOutListing& listing, const DisplaySet& set) const;
    /// Declares `toneMapped(vec3 light)`.
    void write(SourceBuilder& fragment) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const ToneEffect&, const ToneEffect&) = default;
};

} // namespace patina
