// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/opacity.h"

#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Limits how little of the light a model is taken to keep: below half of an 8-bit step.
constexpr double minKept = 1.0 / 1024.0;

std::span<const Parameter> parametersOf(const Block* model) {
    return model ? std::span(model->parameters) : std::span<const Parameter>();
}

/// Tells whether an image says at each place how much the model transmits.
bool passesByImage(const EffectSet& set) {
    return std::ranges::any_of(set.textures, [](const BoundTexture& image) {
        return image.role == TextureRole::Input && image.kind == kinds::models &&
               image.parameter->transparency;
    });
}

/// Writes the share that the model keeps, an expression of its values at a pixel.
std::string keptSource(const Block& model) {
    std::string share = "1.0";
    for (const Parameter& parameter : model.parameters) {
        if (parameter.transparency) {
            share += fmt::format(" * (1.0 - model.{})", fieldName(parameter.id));
        }
    }
    return fmt::format("max({}, {})", share, minKept);
}

bool hasImagedShare(const Material& material, const Block* model) {
    return std::ranges::any_of(parametersOf(model), [&material](const Parameter& parameter) {
        return parameter.transparency && isTextured(parameter.id, material);
    });
}

std::string opacityText(const EffectSubject& subject) {
    const double passed = saidShare(*subject.material, subject.catalog);
    std::string text = fmt::format("The material's opacity is {:.3g}", subject.material->opacity);
    if (passed > 0.0) {
        text += fmt::format(", and its model transmits {:.3g} % of the light", 100.0 * passed);
    }
    const Block* model = subject.catalog.find(kinds::models, subject.material->model.id);
    if (hasImagedShare(*subject.material, model)) {
        text += ", and an image says what its model transmits";
    }
    return text + '.';
}

} // namespace

double saidShare(const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    double kept = 1.0;
    for (const Parameter& parameter : parametersOf(model)) {
        const double* share =
            parameter.transparency
                ? std::get_if<double>(&givenValue(parameter, material.model.parameters))
                : nullptr;
        if (share != nullptr && *share > 0.0) {
            kept *= 1.0 - std::min(*share, 1.0);
        }
    }
    return 1.0 - kept;
}

double passedShare(const Material& material, const Catalog& catalog) {
    return std::min(saidShare(material, catalog), 1.0 - minKept);
}

double opacityOf(const Material& material, const Catalog& catalog) {
    return material.opacity * (1.0 - passedShare(material, catalog));
}

/// A clear body is seen by what it refracts and mirrors.
bool canBeSeen(const Material& material) {
    return material.opacity > 0.0 || material.part(kinds::refraction) != nullptr ||
           isTextured("opacity", material);
}

bool isDrawn(const Object& object) {
    return object.visible && canBeSeen(object.material);
}

bool isTransparent(const Material& material, const Catalog& catalog) {
    return opacityOf(material, catalog) < 1.0 ||
           hasImagedShare(material, catalog.find(kinds::models, material.model.id)) ||
           (isTextured("opacity", material) && !material.textures.find("opacity")->second.cutOut);
}

void OpacityEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    opacity = opacityOf(subject.material, subject.catalog) < 1.0 || passesByImage(set);
}

void OpacityEffect::list(EffectListing& listing, const EffectSet&) const {
    if (opacity) {
        listing.add("opacity", {}, opacityText);
    }
}

/// A model that transmits light has taken its share from what it gives back; so does the opacity.
void OpacityEffect::writeLight(SurfaceText& text) const {
    const auto passes = [](const Parameter& parameter) { return parameter.transparency; };
    if (opacity && passesByImage(text.set)) {
        text.main += fmt::format("    float kept = {};\n    shaded *= 1.0 / kept;\n",
                                 keptSource(text.set.model->block()));
    } else if (opacity && text.set.model &&
               std::ranges::any_of(text.set.model->block().parameters, passes)) {
        text.main += fmt::format("    shaded *= objectData[{}].y;\n", ObjectLayout::surface);
    }
}

void OpacityEffect::write(SurfaceText& text) const {
    if (opacity) {
        text.out.add(fmt::format("#define OPACITY objectData[{}].x\n", ObjectLayout::surface));
        text.alpha = "OPACITY";
        if (passesByImage(text.set) && text.output != SurfaceOutput::Buffer) {
            // The material's own opacity, times what is kept here in place of the value's share.
            text.alpha = fmt::format("(OPACITY * objectData[{}].y * kept)", ObjectLayout::surface);
        }
    }
    text.last = text.textures.opacity(text.alpha);
}

void OpacityEffect::remove(Scene& scene, const EffectName& effect, const Catalog& catalog) {
    if (effect.kind != "opacity") {
        return;
    }
    for (Object& object : scene.objects) {
        object.material.opacity = 1.0;
        const Block* model = catalog.find(kinds::models, object.material.model.id);
        for (const Parameter& parameter : parametersOf(model)) {
            if (parameter.transparency) {
                object.material.model.parameters[parameter.id] = 0.0;
                object.material.textures.erase(parameter.id);
            }
        }
    }
}

} // namespace patina
