// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/texture_effects.h"

#include <fmt/format.h>

#include "shading/effects/texture_choice.h"

namespace patina {
namespace {

TextureEffect effectOf(const std::string& id, const TextureUse& use, const TextureTarget& target) {
    TextureEffect effect;
    effect.id = id;
    effect.role = target.role;
    effect.channel = channelOf(use, target);
    effect.isUsualChannel = effect.channel != use.channel;
    effect.mode = use.mode;
    effect.cutOut = target.role == TextureRole::Opacity && use.cutOut;
    if (target.parameter != nullptr) {
        effect.kind = target.kind;
        effect.field = fieldName(target.parameter->id);
        effect.isColor = target.parameter->type == ParameterType::Color;
        effect.range = {target.parameter->min, target.parameter->max};
    }
    return effect;
}

const char* modeText(TextureMode mode) {
    switch (mode) {
    case TextureMode::Multiply:
        return "multiplied";
    case TextureMode::Add:
        return "added";
    default:
        return "in place of the value";
    }
}

const char* channelText(const TextureEffect& texture) {
    switch (texture.channel) {
    case TextureChannel::Red:
        return "red";
    case TextureChannel::Green:
        return "green";
    case TextureChannel::Blue:
        return "blue";
    case TextureChannel::Alpha:
        return texture.isUsualChannel ? "alpha, or grey without one" : "alpha";
    default:
        return "colour";
    }
}

} // namespace

void addTextures(EffectSet& set, const Material& material, const Catalog& catalog) {
    for (const auto& [id, use] : material.textures) {
        const TextureTarget target = textureTarget(id, use, material, catalog);
        const std::string what = "texture/" + id;
        if (target.whyNot != nullptr) {
            set.leftOut.push_back({what, target.whyNot});
        } else if (!set.model) {
            set.leftOut.push_back({what, "The model is not known."});
        } else if (set.textures.size() == maxTextures) {
            set.leftOut.push_back(
                {what, fmt::format("A material shows {} images at most.", maxTextures)});
        } else {
            set.textures.push_back(effectOf(id, use, target));
        }
    }
}

TextureEffect textureEffect(const std::string& id, const TextureUse& use, const Material& material,
                            const Catalog& catalog) {
    return effectOf(id, use, textureTarget(id, use, material, catalog));
}

EffectLine lineOf(const TextureEffect& texture) {
    const std::string detail =
        texture.role == TextureRole::Normal || texture.role == TextureRole::Height
            ? std::string()
            : fmt::format("{}, {}{}", channelText(texture), modeText(texture.mode),
                          texture.cutOut ? ", cut out" : "");
    return {"texture/" + texture.id, detail, "An image is bound to it."};
}

} // namespace patina
