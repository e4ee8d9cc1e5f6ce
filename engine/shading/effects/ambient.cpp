// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/ambient.h"

#include <algorithm>

#include <fmt/format.h>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

bool claimsIsotropic(const Block& block) {
    return std::ranges::find(block.claims, "isotropic") != block.claims.end();
}

/// Tells whether the model, and what fills its slots, look the same however a surface is turned
/// about its normal. A Fresnel term knows no more than the angle of incidence.
bool isIsotropic(const EffectSet& set) {
    return claimsIsotropic(set.model->block()) &&
           std::ranges::all_of(set.slots, [](const BlockUse& slot) {
               return slot.block().kind == kinds::fresnel || claimsIsotropic(slot.block());
           });
}

} // namespace

void AmbientEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const glm::dvec3& color = subject.scene.ambient;
    ambient = color.x > 0.0 || color.y > 0.0 || color.z > 0.0;
}

void AmbientEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (ambient && isLit(set) && takesAmbient(set)) {
        listing.add("ambient", {}, [](const EffectSubject& subject) {
            return fmt::format("The scene's ambient colour is {}.",
                               colorText(subject.scene.ambient));
        });
    }
}

void AmbientEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    if (ambient && !takesAmbient(set)) {
        listing.add("ambient", drawingText(listing.subject()));
    }
}

void AmbientEffect::writeLight(SurfaceText& text) const {
    if (ambient && text.set.model && takesAmbient(text.set)) {
        const std::string light =
            fmt::format("sceneData[{}].rgb{}", SceneLayout::ambient, text.around.factor);
        text.main += fmt::format("    shaded += {} * {};\n", light, ambientShare(text));
        text.noteTerm("AMBIENT", light + " * modelled", "0.0");
    }
}

std::string ambientShare(SurfaceText& text) {
    text.out.addFile("passes/ambient.glsl");
    std::string share = "ambientShare(s, model)";
    if (isIsotropic(text.set)) {
        text.out.addFile("passes/levelled.glsl");
        share = "ambientShare(levelled(s), model)";
    }
    const std::optional<int> highlight = highlightAmbientData(text.object);
    return highlight ? fmt::format("({} + objectData[{}].rgb)", share, *highlight) : share;
}

void AmbientEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == "ambient") {
        scene.ambient = glm::dvec3(0.0);
    }
}

std::string colorText(const glm::dvec3& color) {
    return fmt::format("{:.3g}, {:.3g}, {:.3g}", color.x, color.y, color.z);
}

} // namespace patina
