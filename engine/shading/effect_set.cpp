// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effect_set.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "shading/effect_choice.h"
#include "shading/effect_key.h"

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

void addLight(SceneEffects& effects, const Block& block, const Light& light, std::uint64_t key) {
    const auto group = std::find_if(effects.lights.begin(), effects.lights.end(),
                                    [key](const LightGroup& known) { return known.key == key; });
    if (group != effects.lights.end()) {
        ++group->count;
    } else {
        effects.lights.push_back({useOf(block, light.block.parameters, {}, {}), 1, key});
    }
}

bool before(const LightGroup& a, const LightGroup& b) {
    const auto key = [](const CompiledValue& value) { return std::tie(value.id, value.value); };
    if (a.block.id != b.block.id) {
        return a.block.id < b.block.id;
    }
    return std::lexicographical_compare(
        a.block.compiled.begin(), a.block.compiled.end(), b.block.compiled.begin(),
        b.block.compiled.end(),
        [&key](const CompiledValue& x, const CompiledValue& y) { return key(x) < key(y); });
}

void addLights(SceneEffects& effects, const Scene& scene, const Catalog& catalog) {
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
            addLight(effects, *block, light, EffectKey::ofLight(light, catalog));
        }
    }
    std::sort(effects.lights.begin(), effects.lights.end(), before);
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

const Block* fresnelBlock(const Material& material, const Catalog& catalog) {
    return material.fresnel ? catalog.find("fresnel", material.fresnel->id) : nullptr;
}

/// The block in a slot: the material's Fresnel block in a slot of its kind, else the default.
void fillSlot(EffectSet& set, const Slot& slot, const Material& material, const Catalog& catalog) {
    const Block* chosen = slot.kind == "fresnel" ? fresnelBlock(material, catalog) : nullptr;
    const Block* block = chosen != nullptr ? chosen : catalog.find(slot.kind, slot.defaultBlock);
    if (block == nullptr) {
        set.leftOut.push_back(
            {slot.kind,
             fmt::format("No block \"{}\" is known for the model's slot.", slot.defaultBlock)});
        return;
    }
    const std::string reason = chosen != nullptr ? "The model calls the material's Fresnel term."
                                                 : "The model calls a term of this kind and the "
                                                   "material chooses none.";
    static const Values none;
    set.slots.push_back(useOf(*block, chosen != nullptr ? material.fresnel->parameters : none,
                              material.accuracy, reason));
}

void addModel(EffectSet& set, const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find("models", material.model.id);
    if (model == nullptr) {
        set.leftOut.push_back({"the model", fmt::format("No model \"{}\" is known; a plain "
                                                        "stand-in is drawn.",
                                                        material.model.id)});
        return;
    }
    for (const Slot& slot : model->slots) {
        fillSlot(set, slot, material, catalog);
    }
    if (set.slots.size() != model->slots.size()) {
        set.slots.clear();
        return;
    }
    set.model =
        useOf(*model, material.model.parameters, material.accuracy, "The material's model.");
    set.fresnelMode = hasFresnelSlot(*model) ? FresnelMode::Slot : FresnelMode::None;
}

void addBlend(EffectSet& set, const Material& material, const Catalog& catalog) {
    if (!material.fresnel || set.fresnelMode == FresnelMode::Slot) {
        return;
    }
    if (const Block* block = fresnelBlock(material, catalog)) {
        set.fresnelMode = FresnelMode::Blend;
        set.blend = useOf(*block, material.fresnel->parameters, material.accuracy,
                          "The material has a Fresnel term and the model has no slot for it.");
    } else {
        set.leftOut.push_back({"the Fresnel term", fmt::format("No Fresnel term \"{}\" is known.",
                                                               material.fresnel->id)});
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
    effects.ambient = scene.ambient.x > 0.0 || scene.ambient.y > 0.0 || scene.ambient.z > 0.0;
    return effects;
}

EffectSet effectSet(const Material& material, const Scene& scene, const Catalog& catalog) {
    EffectSet set;
    addModel(set, material, catalog);
    addBlend(set, material, catalog);
    set.opacity = material.opacity < 1.0;
    set.scene = sceneEffects(scene, catalog);
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
    for (const LightGroup& group : set.scene.lights) {
        lines.push_back(lineOf(group.block));
    }
    if (set.scene.ambient) {
        lines.push_back({"ambient", {}, "The scene's ambient colour is not black."});
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
