// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/emission.h"

#include <algorithm>

#include <fmt/format.h>

#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"
#include "shading/program/given_value.h"

namespace patina {

bool isEmitted(const Parameter& parameter, const Values& values) {
    return parameter.emission && !notPositive(givenValue(parameter, values));
}

void EmissionEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    emission.clear();
    if (!set.model) {
        return;
    }
    for (const Parameter& parameter : set.model->block().parameters) {
        if (isEmitted(parameter, subject.material.model.parameters) ||
            (parameter.emission && isTextured(parameter.id, subject.material))) {
            emission.push_back(&parameter);
        }
    }
}

void EmissionEffect::addTo(ChoiceHash& hash) const {
    hash.add(std::uint64_t(emission.size()));
    for (const Parameter* color : emission) {
        hash.add(std::string_view(color->id));
    }
}

void EmissionEffect::list(EffectListing& listing, const EffectSet&) const {
    for (const Parameter* color : emission) {
        listing.add("emission", color->id,
                    always("The surface glows by itself: the colour is not black."));
    }
}

void EmissionEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    if (!set.model) {
        return;
    }
    for (const Parameter& parameter : set.model->block().parameters) {
        if (parameter.emission && std::ranges::find(emission, &parameter) == emission.end()) {
            listing.add("emission", fmt::format("{} is black.", parameter.label));
        }
    }
}

/// Adds emission once per pixel, whatever the number of lights: no Fresnel term covers what a
/// surface sends out by itself.
void EmissionEffect::write(SurfaceText& text) const {
    for (const Parameter* color : emission) {
        const std::string value = "model." + fieldName(color->id);
        text.main += fmt::format("    shaded += {};\n", value);
        text.noteTerm("EMISSION", value, "0.0");
    }
}

void EmissionEffect::remove(Scene& scene, const EffectName& effect, const Catalog& catalog) {
    if (effect.kind != "emission") {
        return;
    }
    for (Object& object : scene.objects) {
        const Block* model = catalog.find(kinds::models, object.material.model.id);
        for (const Parameter& parameter : model ? model->parameters : std::vector<Parameter>()) {
            if (isEmitted(parameter, object.material.model.parameters)) {
                object.material.model.parameters[parameter.id] = glm::dvec3(0.0);
            }
            if (parameter.emission) {
                object.material.textures.erase(parameter.id);
            }
        }
    }
}

} // namespace patina
