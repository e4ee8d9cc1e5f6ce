// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shading/effects/effect_parts.h"
#include "shading/program/source_builder.h"

namespace patina {

struct DisplaySet;

/// Holds the exposure of the picture. It is left out where it is 0 stops.
struct ExposureEffect {
    bool isExposed = false;

    void choose(const Scene& scene, const Catalog& catalog);
    void addTo(ChoiceHash& hash) const { hash.add(isExposed); }
    void list(EffectListing& listing, const DisplaySet& set) const;
    void listMissing(LeftOutListing& listing, const DisplaySet& set) const;
    void write(SourceBuilder& fragment) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const ExposureEffect&, const ExposureEffect&) = default;
};

} // namespace patina
