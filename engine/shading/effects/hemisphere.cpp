// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/hemisphere.h"

#include <fmt/format.h>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"
#include "shading/program/given_value.h"

namespace patina {

void HemisphereEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const Hemisphere& wanted = subject.scene.hemisphere;
    hemisphere = !notPositive(wanted.sky) || !notPositive(wanted.ground);
}

void HemisphereEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (hemisphere && isLit(set)) {
        listing.add("hemisphere", {}, [](const EffectSubject& subject) {
            return fmt::format("The sky sends {}, the ground {}.",
                               colorText(subject.scene.hemisphere.sky),
                               colorText(subject.scene.hemisphere.ground));
        });
    }
}

void HemisphereEffect::place(SceneLayout& layout, const EffectSet&) const {
    if (hemisphere) {
        layout.hemisphere = layout.firstLight;
        layout.firstLight += 3;
    }
}

std::string hemisphereLight(SurfaceText& text) {
    text.out.addFile("passes/hemisphere.glsl");
    const int first = *text.scene.hemisphere;
    return fmt::format("hemisphereLight(s, sceneData[{}].rgb, sceneData[{}].rgb, "
                       "sceneData[{}].xyz)",
                       first, first + 1, first + 2);
}

void HemisphereEffect::writeLight(SurfaceText& text) const {
    if (hemisphere && text.set.model) {
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
