// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effect_set.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "shading/effect_choice.h"
#include "shading/effect_key.h"
#include "shading/texture_choice.h"
#include "shading/texture_effects.h"

namespace patina {
namespace {

std::string stateText(const Parameter& parameter, const Values& values) {
    const std::size_t state = compiledState(parameter, values);
    if (parameter.compiled == Compiled::WhenZero) {
        return state == 0 ? "zero" : "nonzero";
    }
    if (parameter.type == ParameterType::Bool) {
        return state == 0 ? "false" : "true";
    }
    return state < parameter.values.size() ? parameter.values[state].id : std::string();
}

std::vector<CompiledValue> compiledValues(const Block& block, const Values& values,
                                          const AccuracyLevels& levels) {
    std::vector<CompiledValue> out;
    for (const Parameter& parameter : block.parameters) {
        if (parameter.compiled != Compiled::No) {
            out.push_back({parameter.id, stateText(parameter, values)});
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        if (!choice.values.empty()) {
            out.push_back({choice.id, choice.values[chosenIndex(choice, levels)].id});
        }
    }
    return out;
}

BlockUse useOf(const Block& block, const Values& values, const AccuracyLevels& levels,
               std::string reason) {
    return {block.kind, block.id, compiledValues(block, values, levels), std::move(reason)};
}

std::string lightName(const Light& light) {
    return light.name.empty() ? fmt::format("a light of kind \"{}\"", light.block.id)
                              : fmt::format("the light \"{}\"", light.name);
}

void addLight(SceneEffects& effects, const Block& block, const Light& light, std::uint64_t key,
              const Block* shadow) {
    const auto group = std::find_if(effects.lights.begin(), effects.lights.end(),
                                    [key](const LightGroup& known) { return known.key == key; });
    if (group != effects.lights.end()) {
        ++group->count;
    } else {
        LightGroup made{useOf(block, light.block.parameters, {}, {}), std::nullopt,
                        ShadowProjection::None, 1, key};
        if (shadow != nullptr) {
            made.shadow = useOf(*shadow, light.shadow->parameters, {},
                                "Objects cast shadows in this light.");
            made.projection = block.shadowProjection;
        }
        effects.lights.push_back(std::move(made));
    }
}

/// Why a light's shadows are not drawn; empty when they are, or none are asked for.
std::string reasonWithoutShadow(const Light& light, const Block& block, const Catalog& catalog,
                                bool hasCaster) {
    if (!light.shadow) {
        return {};
    }
    if (block.shadowProjection == ShadowProjection::None) {
        return "Lights of this kind cast none.";
    }
    if (catalog.find("shadows", light.shadow->id) == nullptr) {
        return fmt::format("No kind of shadow \"{}\" is known.", light.shadow->id);
    }
    return hasCaster ? std::string() : "No object casts a shadow.";
}

bool before(const BlockUse& a, const BlockUse& b) {
    const auto key = [](const CompiledValue& value) { return std::tie(value.id, value.value); };
    if (a.id != b.id) {
        return a.id < b.id;
    }
    return std::lexicographical_compare(
        a.compiled.begin(), a.compiled.end(), b.compiled.begin(), b.compiled.end(),
        [&key](const CompiledValue& x, const CompiledValue& y) { return key(x) < key(y); });
}

bool groupBefore(const LightGroup& a, const LightGroup& b) {
    if (before(a.block, b.block) || before(b.block, a.block)) {
        return before(a.block, b.block);
    }
    return b.shadow && (!a.shadow || before(*a.shadow, *b.shadow));
}

void addLights(SceneEffects& effects, const Scene& scene, const Catalog& catalog) {
    const bool casters = hasCaster(scene);
    for (const Light& light : scene.lights) {
        const Block* block = catalog.find("lights", light.block.id);
        if (!light.enabled) {
            effects.leftOut.push_back({lightName(light), "It is switched off."});
        } else if (block == nullptr) {
            effects.leftOut.push_back(
                {lightName(light), fmt::format("No light \"{}\" is known.", light.block.id)});
        } else if (!canShine(light, *block)) {
            effects.leftOut.push_back({lightName(light), "It is black."});
        } else {
            const Block* shadow = casters ? shadowBlock(light, *block, catalog) : nullptr;
            addLight(effects, *block, light, EffectKey::ofLight(light, catalog, casters), shadow);
            if (auto why = reasonWithoutShadow(light, *block, catalog, casters); !why.empty()) {
                effects.leftOut.push_back({"the shadows of " + lightName(light), std::move(why)});
            }
        }
    }
    std::sort(effects.lights.begin(), effects.lights.end(), groupBefore);
    for (LightGroup& group : effects.lights) {
        group.block.reason = group.count == 1
                                 ? "One light of this kind shines."
                                 : fmt::format("{} lights of this kind shine.", group.count);
    }
}

void addFog(SceneEffects& effects, const Scene& scene, const Catalog& catalog) {
    if (!scene.fog) {
        return;
    }
    const Block* block = catalog.find("fog", scene.fog->id);
    if (block == nullptr) {
        effects.leftOut.push_back({"fog", fmt::format("No fog \"{}\" is known.", scene.fog->id)});
    } else if (!canHide(*scene.fog, *block)) {
        effects.leftOut.push_back({"fog", "Its density is 0."});
    } else {
        effects.fog = useOf(*block, scene.fog->parameters, {}, "The scene has fog.");
    }
}

void addEnvironment(SceneEffects& effects, const Scene& scene, const Catalog& catalog) {
    const EnvironmentChoice choice = environmentChoice(scene, catalog);
    if (choice.block != nullptr) {
        effects.environment = useOf(*choice.block, scene.environment->parameters, {},
                                    "The scene has an environment that sends light.");
    } else if (scene.environment) {
        effects.leftOut.push_back({"environment/" + scene.environment->id, choice.whyNot});
    }
}

const char* reasonOf(const SlotChoice& choice) {
    return choice.chosen ? "The model calls the block that the material chooses."
                         : "The model calls a block of this kind and the material chooses none.";
}

/// False when the slot needs a block that the catalogue lacks.
bool fillSlot(EffectSet& set, const Slot& slot, const Material& material, const Catalog& catalog) {
    const SlotChoice choice = slotChoice(slot, material, catalog);
    const BlockValues* part = material.part(slot.kind);
    if (part != nullptr && !choice.chosen) {
        set.leftOut.push_back(
            {slot.kind, fmt::format("No block \"{}\" is known for the model's slot.", part->id)});
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
        if (model.slot(kind) == nullptr && kind != "fresnel") {
            set.leftOut.push_back({kind + '/' + values.id, "The model has no slot for it."});
        }
    }
}

void addModel(EffectSet& set, const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find("models", material.model.id);
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
    for (const Parameter& parameter : model->parameters) {
        if (isEmitted(parameter, material.model.parameters) ||
            (parameter.emission && isTextured(parameter.id, material))) {
            set.emission.push_back(parameter.id);
        }
    }
    set.model =
        useOf(*model, material.model.parameters, material.accuracy, "The material's model.");
    set.fresnelMode = hasFresnelSlot(*model) ? FresnelMode::Slot : FresnelMode::None;
}

void addBlend(EffectSet& set, const Material& material, const Catalog& catalog) {
    const BlockValues* part = material.part("fresnel");
    if (part == nullptr || set.fresnelMode == FresnelMode::Slot) {
        return;
    }
    if (const Block* block = catalog.find("fresnel", part->id)) {
        set.fresnelMode = FresnelMode::Blend;
        set.blend = useOf(*block, part->parameters, material.accuracy,
                          "The material has a Fresnel term and the model has no slot for it.");
    } else {
        set.leftOut.push_back(
            {"the Fresnel term", fmt::format("No Fresnel term \"{}\" is known.", part->id)});
    }
}

std::string detailOf(const BlockUse& use) {
    std::string out;
    for (const CompiledValue& value : use.compiled) {
        fmt::format_to(std::back_inserter(out), "{}{}={}", out.empty() ? "" : ", ", value.id,
                       value.value);
    }
    return out;
}

EffectLine lineOf(const BlockUse& use) {
    return {use.kind + '/' + use.id, detailOf(use), use.reason};
}

} // namespace

SceneEffects sceneEffects(const Scene& scene, const Catalog& catalog) {
    SceneEffects effects;
    addLights(effects, scene, catalog);
    addFog(effects, scene, catalog);
    addEnvironment(effects, scene, catalog);
    effects.ambient = scene.ambient.x > 0.0 || scene.ambient.y > 0.0 || scene.ambient.z > 0.0;
    effects.hemisphere = hasHemisphere(scene);
    return effects;
}

EffectSet effectSet(const Material& material, const Scene& scene, const Catalog& catalog) {
    EffectSet set;
    addModel(set, material, catalog);
    addBlend(set, material, catalog);
    addTextures(set, material, catalog);
    set.opacity = material.opacity < 1.0;
    set.scene = sceneEffects(scene, catalog);
    return set;
}

EffectSet groundEffects(const Scene& scene, const Catalog& catalog) {
    EffectSet set;
    set.scene = sceneEffects(scene, catalog);
    set.ground = isSeen(scene.ground) ? scene.ground.mode : GroundMode::Off;
    const bool shadowed = std::any_of(set.scene.lights.begin(), set.scene.lights.end(),
                                      [](const LightGroup& group) { return bool(group.shadow); });
    if (set.ground == GroundMode::Shadows && !shadowed) {
        set.ground = GroundMode::Off;
        set.leftOut.push_back({"the ground", "It shows shadows only, and no light has any."});
    }
    return set;
}

std::vector<EffectLine> effectLines(const EffectSet& set) {
    std::vector<EffectLine> lines;
    if (set.model) {
        lines.push_back(lineOf(*set.model));
    }
    for (const BlockUse& slot : set.slots) {
        lines.push_back(lineOf(slot));
    }
    if (set.ground != GroundMode::Off) {
        lines.push_back({"ground", {}, "The scene has a ground."});
    }
    for (const LightGroup& group : set.scene.lights) {
        lines.push_back(lineOf(group.block));
        if (group.shadow) {
            lines.push_back(lineOf(*group.shadow));
        }
    }
    if (set.scene.ambient) {
        lines.push_back({"ambient", {}, "The scene's ambient colour is not black."});
    }
    if (set.scene.hemisphere) {
        lines.push_back(
            {"hemisphere", {}, "The sky or the ground of the ambient light is not black."});
    }
    if (set.scene.environment) {
        lines.push_back(lineOf(*set.scene.environment));
    }
    for (const std::string& color : set.emission) {
        lines.push_back(
            {"emission", color, "The surface glows by itself: the colour is not black."});
    }
    for (const TextureEffect& texture : set.textures) {
        lines.push_back(lineOf(texture));
    }
    if (set.blend) {
        lines.push_back(lineOf(*set.blend));
    }
    if (set.scene.fog) {
        lines.push_back(lineOf(*set.scene.fog));
    }
    if (set.opacity) {
        lines.push_back({"opacity", {}, "The material's opacity is below 1."});
    }
    return lines;
}

} // namespace patina
