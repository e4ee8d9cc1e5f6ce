// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/picture_effect.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "shading/effects/effect_set.h"
#include "shading/effects/highlight_width.h"

namespace patina {
namespace {

/// Returns what the first effect says that needs each pixel; empty: none does.
std::string_view whyPerPixel(const EffectSet& set) {
    std::string_view why;
    set.each([&](const auto& effect) {
        if constexpr (requires { effect.whyPerPixel(set); }) {
            why = why.empty() ? effect.whyPerPixel(set) : why;
        }
    });
    return why;
}

/// Is null where nothing needs normals of length 1.
const char* whyUnitNormals(const EffectSet& set) {
    if (set.refraction) {
        return "They have length 1 in a material that refracts light.";
    }
    return isLitByEnvironment(set) ? "They have length 1 under an environment." : nullptr;
}

bool hasWidth(const EffectSet& set) {
    return hasHighlightWidth(set.model->block()) ||
           std::ranges::any_of(
               set.slots, [](const BlockUse& slot) { return hasHighlightWidth(slot.block()); });
}

} // namespace

void PictureEffect::choose(const SceneSubject& subject, const EffectSet&) {
    wantsVertexLight = subject.scene.accuracy.lightsAtVertices();
    wantsBlendedNormals = subject.scene.accuracy.leavesNormals();
    wantsWideHighlights = subject.scene.accuracy.widensHighlights();
}

/// Drops interpolated normals where light comes from the vertices, which need none between them. A
/// pixel's neighbours say how much the surface turns; vertices have none.
void PictureEffect::adjust(const EffectSet& set) {
    const bool hasModel = set.model.has_value();
    lightsAtVertices = hasModel && wantsVertexLight && whyPerPixel(set).empty();
    leavesNormals =
        hasModel && wantsBlendedNormals && !lightsAtVertices && whyUnitNormals(set) == nullptr;
    widensHighlights = hasModel && wantsWideHighlights && !lightsAtVertices && hasWidth(set);
}

void PictureEffect::addTo(ChoiceHash& hash) const {
    hash.add(wantsVertexLight);
    hash.add(wantsBlendedNormals);
    hash.add(wantsWideHighlights);
}

void PictureEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    if (!set.model) {
        return;
    }
    if (const std::string_view why = whyPerPixel(set); wantsVertexLight && !why.empty()) {
        listing.add("vertex lighting", fmt::format("Lighting stays per pixel: {}", why));
    }
    if (const char* why = wantsBlendedNormals ? whyUnitNormals(set) : nullptr) {
        listing.add("blended normals", why);
    }
    if (wantsWideHighlights && !widensHighlights) {
        listing.add("wide highlights", hasWidth(set)
                                           ? "Light that is worked out at vertices is not widened."
                                           : "The model has no highlight with a width.");
    }
}

bool drawsMarks(const Block& model) {
    return std::ranges::any_of(model.parameters,
                               [](const Parameter& parameter) { return parameter.unit == "px"; });
}

} // namespace patina
