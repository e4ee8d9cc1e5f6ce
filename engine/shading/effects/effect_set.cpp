// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_set.h"

#include <algorithm>

#include <fmt/format.h>

#include "material/model_swap.h"
#include "scene/transparency.h"
#include "shading/effects/block_use.h"
#include "shading/effects/effect_choice.h"
#include "shading/effects/fog_depth.h"
#include "shading/effects/light_effects.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/picture_effects.h"
#include "shading/effects/refraction_choice.h"
#include "shading/effects/refraction_effects.h"
#include "shading/effects/texture_choice.h"
#include "shading/effects/texture_effects.h"
#include "shading/program/table_layout.h"

namespace patina {
namespace {

void addFog(SceneEffects& effects, const Scene& scene, const Catalog& catalog,
            const EffectView& view) {
    if (!scene.part(kinds::fog)) {
        return;
    }
    const Block* block = catalog.find(kinds::fog, scene.part(kinds::fog)->id);
    if (block == nullptr) {
        effects.leftOut.push_back(
            {"fog", fmt::format("No fog \"{}\" is known.", scene.part(kinds::fog)->id)});
    } else if (auto why = whyNeutral(*block, scene.part(kinds::fog)->parameters); !why.empty()) {
        effects.leftOut.push_back({"fog", std::move(why)});
    } else if (!canHide(scene, *block, view)) {
        effects.leftOut.push_back({"fog", fogText(scene, *block, view)});
    } else {
        effects.fog =
            useOf(*block, scene.part(kinds::fog)->parameters, {}, fogText(scene, *block, view));
    }
}

std::string colorText(const glm::dvec3& color) {
    return fmt::format("{:.3g}, {:.3g}, {:.3g}", color.x, color.y, color.z);
}

void addAmbient(SceneEffects& effects, const Scene& scene) {
    effects.ambient = hasAmbient(scene);
    effects.hemisphere = hasHemisphere(scene);
    if (effects.ambient) {
        effects.reasons["ambient"] =
            fmt::format("The scene's ambient colour is {}.", colorText(scene.ambient));
    }
    if (effects.hemisphere) {
        effects.reasons["hemisphere"] =
            fmt::format("The sky sends {}, the ground {}.", colorText(scene.hemisphere.sky),
                        colorText(scene.hemisphere.ground));
    }
}

/// "It is dark. Its “Intensity” is 0."
std::string whyNoEnvironment(const Scene& scene, const Catalog& catalog,
                             const EnvironmentChoice& choice) {
    const Block* block = catalog.find(kinds::environment, scene.part(kinds::environment)->id);
    const std::string neutral =
        block == nullptr ? std::string()
                         : whyNeutral(*block, scene.part(kinds::environment)->parameters);
    return neutral.empty() ? choice.whyNot : choice.whyNot + (' ' + neutral);
}

void addEnvironment(SceneEffects& effects, const Scene& scene, const Catalog& catalog) {
    const EnvironmentChoice choice = environmentChoice(scene, catalog);
    if (choice.block != nullptr) {
        const Values& values = scene.part(kinds::environment)->parameters;
        effects.environment = useOf(*choice.block, values, {},
                                    isNeutral(*choice.block, values)
                                        ? "It is dark, and what an object bends shows it."
                                        : "The scene has an environment that sends light.");
    } else if (scene.part(kinds::environment)) {
        effects.leftOut.push_back({"environment/" + scene.part(kinds::environment)->id,
                                   whyNoEnvironment(scene, catalog, choice)});
    }
}

std::string transparentObjects(int count) {
    return count == 1 ? std::string("One object lets something through")
                      : fmt::format("{} objects let something through", count);
}

/// Says how the layers of transparent surfaces are put together.
const char* wayOf(const Scene& scene, const Block* block) {
    if (block == nullptr) {
        return "each is blended over what is behind it, far ones first";
    }
    return layersOf(*scene.part(kinds::transparency), *block) > 0
               ? "the layers of each pixel are put in their order"
               : "all layers of a pixel are mixed at once";
}

void addTransparency(SceneEffects& effects, const Scene& scene, const Catalog& catalog) {
    const int count = countTransparent(scene, catalog);
    if (count == 0) {
        if (scene.part(kinds::transparency)) {
            effects.leftOut.push_back({"transparency/" + scene.part(kinds::transparency)->id,
                                       "No object lets anything through."});
        }
        return;
    }
    const Block* block = transparencyBlock(scene, catalog);
    const std::string reason =
        fmt::format("{}: {}.", transparentObjects(count), wayOf(scene, block));
    if (block != nullptr) {
        effects.transparency =
            useOf(*block, scene.part(kinds::transparency)->parameters, {}, reason);
        return;
    }
    effects.reasons["transparency"] = reason;
    if (scene.part(kinds::transparency)) {
        effects.leftOut.push_back({"transparency/" + scene.part(kinds::transparency)->id,
                                   "No transparency of this kind is known."});
    }
}

const char* reasonOf(const SlotChoice& choice) {
    return choice.chosen ? "The material chooses it for the model."
                         : "The model needs one and the material chooses none.";
}

/// False when the slot needs a block that the catalogue lacks.
bool fillSlot(EffectSet& set, const Slot& slot, const Material& material, const Catalog& catalog) {
    const SlotChoice choice = slotChoice(slot, material, catalog);
    const BlockValues* part = material.part(slot.kind);
    if (part != nullptr && !choice.chosen) {
        set.leftOut.push_back(
            {slot.kind, fmt::format("No block \"{}\" is known for the model's slot.", part->id)});
    }
    if (isNeutral(choice, material)) {
        set.leftOut.push_back({slot.kind + '/' + choice.block->id,
                               whyNeutral(*choice.block, *choice.values, material.accuracy)});
        return true;
    }
    if (choice.block != nullptr) {
        set.slots.push_back(
            useOf(*choice.block, *choice.values, material.accuracy, reasonOf(choice)));
        return true;
    }
    if (!slot.defaultBlock.empty()) {
        set.leftOut.push_back(
            {slot.kind,
             fmt::format("No block \"{}\" is known for the model's slot.", slot.defaultBlock)});
    }
    return slot.defaultBlock.empty();
}

/// What the material chooses and the model does not call, but for what blends the sum.
void nameUnusedParts(EffectSet& set, const Block& model, const Material& material) {
    for (const auto& [kind, values] : material.parts) {
        if (!hasPlaceFor(model, kind)) {
            set.leftOut.push_back({kind + '/' + values.id, "The model has no slot for it."});
        }
    }
}

void addEmission(EffectSet& set, const Block& model, const Material& material) {
    for (const Parameter& parameter : model.parameters) {
        if (isEmitted(parameter, material.model.parameters) ||
            (parameter.emission && isTextured(parameter.id, material))) {
            set.emission.push_back(parameter.id);
        }
    }
}

void nameBlackEmission(EffectSet& set, const Catalog& catalog) {
    const Block* model = set.model ? catalog.find(kinds::models, set.model->id) : nullptr;
    for (const Parameter& parameter : model ? model->parameters : std::vector<Parameter>()) {
        const bool glows =
            std::find(set.emission.begin(), set.emission.end(), parameter.id) != set.emission.end();
        if (parameter.emission && !glows) {
            set.leftOut.push_back({"emission", fmt::format("{} is black.", parameter.label)});
        }
    }
}

/// Two values are the same everywhere only while no image changes one of them.
void forgetEqualOfTextured(EffectSet& set, const Catalog& catalog) {
    const auto hasImage = [&set](const std::string& id) {
        return std::any_of(set.textures.begin(), set.textures.end(),
                           [&id](const TextureEffect& texture) { return texture.id == id; });
    };
    for (std::size_t i = 0; set.model && i < set.model->compiled.size(); ++i) {
        CompiledValue& value = set.model->compiled[i];
        const Parameter* parameter =
            catalog.find(kinds::models, set.model->id)->parameter(value.id);
        const bool isEqual = parameter != nullptr && value.value == "equal";
        if (isEqual && (hasImage(value.id) || hasImage(parameter->equalTo))) {
            value.value = "unequal";
        }
    }
}

/// "Roughness x and roughness y are both 0.3.": which difference is not in the program.
void nameEqual(EffectSet& set, const Material& material, const Catalog& catalog) {
    const Block* model = set.model ? catalog.find(kinds::models, set.model->id) : nullptr;
    for (const CompiledValue& value :
         set.model ? set.model->compiled : std::vector<CompiledValue>()) {
        const Parameter* parameter = model->parameter(value.id);
        if (parameter == nullptr || parameter->compiled != Compiled::WhenEqual ||
            value.value != "equal") {
            continue;
        }
        const Value& both = givenValue(*parameter, material.model.parameters);
        if (const auto* number = std::get_if<double>(&both)) {
            set.leftOut.push_back(
                {"anisotropy", fmt::format("{} and {} are both {:.4g}.",
                                           model->parameter(parameter->equalTo)->label,
                                           parameter->label, *number)});
        }
    }
}

void addOpacity(EffectSet& set, const Material& material, const Catalog& catalog) {
    set.opacity = opacityOf(material, catalog) < 1.0;
    if (!set.opacity) {
        return;
    }
    const double passed = saidShare(material, catalog);
    std::string& reason = set.reasons["opacity"];
    reason = fmt::format("The material's opacity is {:.3g}", material.opacity);
    if (passed > 0.0) {
        reason += fmt::format(", and its model lets {:.3g} % of the light pass", 100.0 * passed);
    }
    reason += '.';
}

void addOutline(EffectSet& set, const Material& material, const Catalog& catalog) {
    const OutlineChoice choice = outlineChoice(material, catalog);
    const BlockValues* part = material.part(kinds::outline);
    if (choice.block != nullptr) {
        set.outline = useOf(*choice.block, part->parameters, material.accuracy,
                            "The material has lines along the edges of its shape.");
    } else if (part != nullptr) {
        set.leftOut.push_back({"outline/" + part->id, choice.whyNot});
    }
}

void addModel(EffectSet& set, const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (model == nullptr) {
        set.leftOut.push_back({"the model", fmt::format("No model \"{}\" is known; a plain "
                                                        "stand-in is drawn.",
                                                        material.model.id)});
        return;
    }
    bool whole = true;
    for (const Slot& slot : model->slots) {
        whole = fillSlot(set, slot, material, catalog) && whole;
    }
    if (!whole) {
        set.slots.clear();
        return;
    }
    nameUnusedParts(set, *model, material);
    addEmission(set, *model, material);
    set.model =
        useOf(*model, material.model.parameters, material.accuracy, "The material's model.");
    set.fresnelMode = hasFresnelSlot(*model) ? FresnelMode::Slot : FresnelMode::None;
}

/// A fallback for an unknown model keeps its stripes: blending it would hide them. Where the model
/// was left out, as to see what it does, the blend stays.
void addBlend(EffectSet& set, const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part(kinds::fresnel);
    const std::string& model = material.model.id;
    const bool isUnknown = !model.empty() && catalog.find(kinds::models, model) == nullptr;
    if (part == nullptr || isUnknown || set.fresnelMode == FresnelMode::Slot) {
        return;
    }
    const Block* block = catalog.find(kinds::fresnel, part->id);
    if (block != nullptr && isNeutralPart(*block, part->parameters, material)) {
        set.leftOut.push_back(
            {"fresnel/" + part->id, whyNeutral(*block, part->parameters, material.accuracy)});
    } else if (block != nullptr) {
        set.fresnelMode = FresnelMode::Blend;
        set.blend = useOf(*block, part->parameters, material.accuracy,
                          "The material has a Fresnel term and the model has no slot for it.");
    } else {
        set.leftOut.push_back(
            {"fresnel", fmt::format("No Fresnel term \"{}\" is known.", part->id)});
    }
}

} // namespace

SceneEffects sceneEffects(const Scene& scene, const Catalog& catalog, const EffectView& view) {
    SceneEffects effects;
    addLights(effects, scene, catalog, view);
    addFog(effects, scene, catalog, view);
    addEnvironment(effects, scene, catalog);
    addTransparency(effects, scene, catalog);
    addAmbient(effects, scene);
    effects.isShownRefracted = showsSceneRefracted(scene, catalog);
    addPictureEffects(effects, scene);
    return effects;
}

EffectSet effectSet(const Material& material, const Scene& scene, const Catalog& catalog,
                    const EffectView& view) {
    EffectSet set;
    addModel(set, material, catalog);
    addBlend(set, material, catalog);
    addTextures(set, material, catalog);
    forgetEqualOfTextured(set, catalog);
    forgetTablesOfTextured(set, catalog);
    nameBlackEmission(set, catalog);
    nameEqual(set, material, catalog);
    addOpacity(set, material, catalog);
    addOutline(set, material, catalog);
    set.scene = sceneEffects(scene, catalog, view);
    addRefraction(set, material, scene, catalog);
    addPictureWork(set, catalog);
    return set;
}

bool isVisiblyTransparent(const EffectSet& set) {
    return set.opacity || std::ranges::any_of(set.textures, [](const TextureEffect& texture) {
               return texture.role == TextureRole::Opacity && !texture.cutOut;
           });
}

EffectSet groundEffects(const Scene& scene, const Catalog& catalog, const EffectView& view) {
    EffectSet set;
    set.scene = sceneEffects(scene, catalog, view);
    addGround(set, scene);
    return set;
}

} // namespace patina
