// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shading/effects/effect_parts.h"
#include "shading/program/source_builder.h"

namespace patina {

/// Tells a model that draws on the surface where on it a pixel is: the parameters of the roles
/// `place`, `coordinates` and their like are set at each pixel.
struct DrawnPlaceEffect {
    const Block* drawing = nullptr; ///< is the model; null: it does not draw on the surface

    static constexpr bool isKnownToReference = true; // but for what bends

    void choose(const MaterialSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash&) const {} // the model is in it
    void list(EffectListing& listing, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    std::string writeVertex(SourceBuilder& vertex) const;
    int bufferValues() const;
    void writeBuffer(SurfaceText& text, std::size_t place) const;
    std::string_view whyPerPixel(const EffectSet&) const {
        return drawing == nullptr ? std::string_view() : "the model draws on each pixel.";
    }

    friend bool operator==(const DrawnPlaceEffect&, const DrawnPlaceEffect&) = default;
};

/// Returns the model's parameters that are set at each pixel, in the order of the values that a
/// surface buffer has of them; the first is at bufferPlace<DrawnPlaceEffect>(). They are none where
/// the model is told how the surface bends, which a surface buffer does not know.
std::vector<const Parameter*> placedParameters(const DrawnPlaceEffect& effect);

/// Tells whether the model lays a pattern on texture coordinates.
bool laysPattern(const DrawnPlaceEffect& effect);

/// Tells whether the model is told how the surface bends.
bool readsCurvature(const DrawnPlaceEffect& effect);

} // namespace patina
