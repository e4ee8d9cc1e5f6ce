// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/hemisphere.h"

#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"
#include "shading/program/given_value.h"
#include "shading/program/storable.h"

namespace patina {
namespace {

/// Packs the sky, the ground and the unit direction up.
void packHemisphere(std::span<glm::vec4> out, const Scene& scene, const EffectSet&) {
    const Hemisphere& hemisphere = scene.hemisphere;
    const double length = glm::length(hemisphere.up);
    const bool isDirection = std::isfinite(length) && length > 1e-30;
    out[0] = storable(hemisphere.sky);
    out[1] = storable(hemisphere.ground);
    out[2] = glm::vec4(isDirection ? hemisphere.up / length : glm::dvec3(0.0, 1.0, 0.0), 0.0);
}

} // namespace

void HemisphereEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const Hemisphere& wanted = subject.scene.hemisphere;
    hemisphere = !notPositive(wanted.sky) || !notPositive(wanted.ground);
}

void HemisphereEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (hemisphere && isLit(set) && takesAmbient(set)) {
        listing.add("hemisphere", {}, [](const EffectSubject& subject) {
            return fmt::format("The sky sends {}, the ground {}.",
                               colorText(subject.scene.hemisphere.sky),
                               colorText(subject.scene.hemisphere.ground));
        });
    }
}

void HemisphereEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    if (hemisphere && !takesAmbient(set)) {
        listing.add("hemisphere", drawingText(listing.subject()));
    }
}

void HemisphereEffect::place(SceneLayout& layout, const EffectSet&) const {
    if (hemisphere) {
        layout.place(packHemisphere, 3, layout.firstLight);
    }
}

std::optional<int> hemisphereData(const SceneLayout& layout) {
    return layout.firstOf(packHemisphere);
}

std::string hemisphereLight(SurfaceText& text) {
    text.out.addFile("passes/hemisphere.glsl");
    const int first = *hemisphereData(text.scene);
    return fmt::format("hemisphereLight({}, sceneData[{}].rgb, sceneData[{}].rgb, "
                       "sceneData[{}].xyz){}",
                       text.around.surface, first, first + 1, first + 2, text.around.factor);
}

void HemisphereEffect::writeLight(SurfaceText& text) const {
    if (hemisphere && text.set.model && takesAmbient(text.set)) {
        const std::string light = hemisphereLight(text);
        text.main += fmt::format("    shaded += {} * {};\n", light, ambientShare(text));
        text.noteTerm("AMBIENT", light + " * modelled", "0.0");
    }
}

void HemisphereEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == "hemisphere") {
        scene.hemisphere = Hemisphere();
    }
}

} // namespace patina
