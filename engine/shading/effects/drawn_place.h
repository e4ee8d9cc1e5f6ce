// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "shading/effects/effect_parts.h"
#include "shading/program/source_builder.h"

namespace patina {

/// Tells a model that draws on the surface where on it a pixel is: the parameters of the roles
/// `place`, `placeNormal`, `placeView` and `placePixel` are set at each pixel.
struct DrawnPlaceEffect {
    const Block* drawing = nullptr; ///< is the model; null: it does not draw on the surface

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash&) const {} // the model is in it
    void list(EffectListing& listing, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    std::string writeVertex(SourceBuilder& vertex) const;
    std::string_view whyPerPixel(const EffectSet&) const {
        return drawing == nullptr ? std::string_view() : "the model draws on each pixel.";
    }

    friend bool operator==(const DrawnPlaceEffect&, const DrawnPlaceEffect&) = default;
};

} // namespace patina
