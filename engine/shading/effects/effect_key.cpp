// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_key.h"

#include <string_view>

#include "shading/effects/effect_choice.h"
#include "shading/effects/light_reach.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/picture_effects.h"
#include "shading/effects/refraction_choice.h"
#include "shading/effects/texture_choice.h"

namespace patina {
namespace {

/// FNV-1a, 64 bits.
class Hash {
  public:
    void add(std::string_view text) {
        for (const char c : text) {
            addByte(static_cast<unsigned char>(c));
        }
        addByte(0);
    }
    void add(std::uint64_t number) {
        for (int shift = 0; shift < 64; shift += 8) {
            addByte(static_cast<unsigned char>(number >> shift));
        }
    }
    std::uint64_t value() const { return value_; }

  private:
    void addByte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }

    std::uint64_t value_ = 0xcbf29ce484222325u;
};

void addBlock(Hash& hash, const Block& block, const Values& values, const AccuracyLevels& levels) {
    hash.add(block.kind);
    hash.add(block.id);
    for (const Parameter& parameter : block.parameters) {
        if (parameter.compiled != Compiled::No) {
            hash.add(compiledState(block, parameter, values));
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        hash.add(chosenIndex(choice, levels));
    }
}

void addModel(Hash& hash, const Block& model, const Material& material, const Catalog& catalog) {
    addBlock(hash, model, material.model.parameters, material.accuracy);
    for (const Slot& slot : model.slots) {
        const SlotChoice choice = slotChoice(slot, material, catalog);
        if (choice.block != nullptr && !isNeutral(choice, material)) {
            addBlock(hash, *choice.block, *choice.values, material.accuracy);
        }
    }
    for (const Parameter& parameter : model.parameters) {
        if (parameter.emission) {
            hash.add(isEmitted(parameter, material.model.parameters) ||
                             isTextured(parameter.id, material)
                         ? 1
                         : 0);
        }
    }
}

/// As addTextures() of texture_effects.h.
void addTextures(Hash& hash, const Material& material, const Catalog& catalog) {
    std::size_t count = 0;
    for (const auto& [id, use] : material.textures) {
        const TextureTarget target = textureTarget(id, use, material, catalog);
        if (target.whyNot == nullptr && count++ < maxTextures) {
            hash.add(id);
            hash.add(static_cast<std::uint64_t>(channelOf(use, target)));
            hash.add(static_cast<std::uint64_t>(use.mode));
            hash.add(use.cutOut ? 1 : 0);
        }
    }
}

} // namespace

std::uint64_t EffectKey::ofLight(const Light& light, const Catalog& catalog, bool hasShadows) {
    const Block* block = catalog.find(kinds::lights, light.block.id);
    if (block == nullptr || !canShine(light, *block)) {
        return 0;
    }
    static const AccuracyLevels exact;
    Hash hash;
    addBlock(hash, *block, light.block.parameters, exact);
    const Block* shadow = hasShadows ? shadowBlock(light, *block, catalog) : nullptr;
    if (shadow != nullptr) {
        addBlock(hash, *shadow, light.shadow->parameters, exact);
    }
    return hash.value();
}

std::uint64_t EffectKey::ofDisplay(const Scene& scene) {
    return 2 * static_cast<std::uint64_t>(scene.toneMapping) + (scene.exposure == 0.0 ? 0 : 1);
}

std::uint64_t EffectKey::ofEnvironment(const Scene& scene, const Catalog& catalog) {
    const Block* block = environmentChoice(scene, catalog).block;
    if (block == nullptr) {
        return 0;
    }
    static const AccuracyLevels exact;
    Hash hash;
    addBlock(hash, *block, scene.part(kinds::environment)->parameters, exact);
    return hash.value();
}

std::uint64_t EffectKey::ofScene(const Scene& scene, const Catalog& catalog,
                                 const EffectView& view) {
    lines_.clear();
    const bool shadows = hasShadows(scene, catalog);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = catalog.find(kinds::lights, light.block.id);
        lines_.add(ofLight(light, catalog, shadows),
                   block != nullptr && reachOf(light, *block).isEverywhere(), view.reaches(i));
    }
    Hash hash;
    for (const LightLines::Group& group : lines_.groups()) {
        if (!group.isReached) {
            continue;
        }
        hash.add(group.key);
        hash.add(static_cast<std::uint64_t>(lines_.of(group)));
    }
    const Block* fog = blockOf(scene.parts, kinds::fog, catalog);
    const bool hasFog = fog != nullptr && canHide(scene, *fog, view);
    if (hasFog) {
        static const AccuracyLevels exact;
        addBlock(hash, *fog, scene.part(kinds::fog)->parameters, exact);
    }
    if (const Block* transparency = transparencyBlock(scene, catalog)) {
        static const AccuracyLevels exact;
        addBlock(hash, *transparency, scene.part(kinds::transparency)->parameters, exact);
    }
    hash.add(ofEnvironment(scene, catalog));
    hash.add(hasHemisphere(scene) ? 1 : 0);
    hash.add(hasAmbient(scene) ? 1 : 0);
    hash.add(showsSceneRefracted(scene, catalog) ? 1 : 0);
    hash.add(pictureEffectsKey(scene, hasFog));
    return hash.value();
}

std::uint64_t EffectKey::ofMaterial(const Material& material, const Catalog& catalog) {
    Hash hash;
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (model != nullptr) {
        addModel(hash, *model, material, catalog);
    }
    const BlockValues* part = material.part(kinds::fresnel);
    const Block* fresnel = part == nullptr ? nullptr : catalog.find(kinds::fresnel, part->id);
    const bool isUnknown = model == nullptr && !material.model.id.empty();
    if (fresnel != nullptr && !isUnknown && (model == nullptr || !hasFresnelSlot(*model)) &&
        !isNeutralPart(*fresnel, part->parameters, material)) {
        addBlock(hash, *fresnel, part->parameters, material.accuracy);
    }
    if (model != nullptr) {
        addTextures(hash, material, catalog);
    }
    hash.add(opacityOf(material, catalog) < 1.0 ? 1 : 0);
    if (const RefractionChoice choice = refractionChoice(material, catalog);
        choice.block != nullptr) {
        addBlock(hash, *choice.block, *choice.values, material.accuracy);
    }
    if (const Block* outline = outlineChoice(material, catalog).block) {
        addBlock(hash, *outline, material.part(kinds::outline)->parameters, material.accuracy);
    }
    return hash.value();
}

} // namespace patina
