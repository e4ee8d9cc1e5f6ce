// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/container/small_vector.hpp>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Tells whether the block's parameter is a colour that is emitted and not black.
bool isEmitted(const Parameter& parameter, const Values& values);

/// Holds the light that the surface sends out by itself: the model's colours that are emitted and
/// not black everywhere.
struct EmissionEffect {
    static constexpr bool isKnownToReference = true;

    boost::container::small_vector<const Parameter*, 2> emission;

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const;
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    void write(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const EmissionEffect&, const EmissionEffect&) = default;
};

} // namespace patina
