// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/highlight_ambient.h"

#include <algorithm>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/program/given_value.h"
#include "shading/program/storable.h"

namespace patina {
namespace {

/// Returns the ambient colour of what fills a slot; black where it has none.
glm::dvec3 ambientOf(const Block& block, const Material& material) {
    const Parameter* parameter = block.withRole(roles::ambientColor);
    const BlockValues* part = material.part(block.kind);
    static const Values none;
    const auto* color =
        parameter == nullptr
            ? nullptr
            : std::get_if<glm::dvec3>(&givenValue(
                  *parameter, part != nullptr && part->id == block.id ? part->parameters : none));
    return color == nullptr ? glm::dvec3(0.0) : glm::max(*color, glm::dvec3(0.0));
}

void packAmbient(std::span<glm::vec4> out, const Material& material, const EffectSet& set) {
    glm::dvec3 sum(0.0);
    for (const BlockUse& slot : set.slots) {
        sum += ambientOf(slot.block(), material);
    }
    out[0] = storable(sum);
}

bool hasAmbientLight(const EffectSet& set) {
    return takesAmbient(set) && (set.ambient || set.hemisphere ||
                                 std::ranges::any_of(set.lights, &LightGroup::hasAmbient));
}

} // namespace

void HighlightAmbientEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    highlightAmbient = std::ranges::any_of(set.slots, [&subject](const BlockUse& slot) {
        return !notPositive(ambientOf(slot.block(), subject.material));
    });
}

void HighlightAmbientEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (highlightAmbient && isLit(set) && hasAmbientLight(set)) {
        listing.add("highlight-ambient", {}, always("The highlight has an ambient colour."));
    }
}

void HighlightAmbientEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    if (highlightAmbient && !hasAmbientLight(set)) {
        listing.add("highlight-ambient", "There is no ambient light.");
    }
}

void HighlightAmbientEffect::place(ObjectLayout& layout, const EffectSet&) const {
    if (highlightAmbient) {
        layout.place(packAmbient, 1, layout.vec4s);
    }
}

std::optional<int> highlightAmbientData(const ObjectLayout& layout) {
    return layout.firstOf(packAmbient);
}

void HighlightAmbientEffect::remove(Scene& scene, const EffectName& effect,
                                    const Catalog& catalog) {
    if (effect.kind != "highlight-ambient") {
        return;
    }
    for (Object& object : scene.objects) {
        for (auto& [kind, part] : object.material.parts) {
            const Block* block = catalog.find(kind, part.id);
            const Parameter* color =
                block == nullptr ? nullptr : block->withRole(roles::ambientColor);
            if (color != nullptr) {
                part.parameters[color->id] = glm::dvec3(0.0);
            }
        }
    }
}

} // namespace patina
