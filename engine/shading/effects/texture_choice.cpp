// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/texture_choice.h"

#include <algorithm>
#include <array>
#include <utility>

#include "shading/effects/effect_choice.h"

namespace patina {
namespace {

constexpr std::array<std::pair<std::string_view, TextureChannel>, 5> channelNames{
    {{"rgb", TextureChannel::Color},
     {"r", TextureChannel::Red},
     {"g", TextureChannel::Green},
     {"b", TextureChannel::Blue},
     {"a", TextureChannel::Alpha}}};

TextureChannel channelNamed(std::string_view name) {
    for (const auto& [known, channel] : channelNames) {
        if (known == name) {
            return channel;
        }
    }
    return TextureChannel::Red;
}

bool takes(const Parameter& parameter, TextureChannel channel) {
    return std::ranges::any_of(parameter.textureChannels, [channel](const std::string& name) {
        return channelNamed(name) == channel;
    });
}

/// The block that the model's slot of this kind calls, or the Fresnel term that blends the sum.
const Block* partBlock(std::string_view kind, const Block& model, const Material& material,
                       const Catalog& catalog) {
    if (const Slot* slot = model.slot(kind)) {
        return slotChoice(*slot, material, catalog).block;
    }
    const BlockValues* part = material.part(kind);
    return part != nullptr && kind == kinds::fresnel ? catalog.find(kind, part->id) : nullptr;
}

/// Finds the parameter behind a key: the model's own first, then "<kind>.<id>" of a part.
void findParameter(TextureTarget& target, std::string_view key, const Material& material,
                   const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (model == nullptr) {
        return;
    }
    target.kind = model->kind;
    target.parameter = model->parameter(key);
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        const bool isPart =
            key.size() > kind.size() + 1 && key.starts_with(kind) && key[kind.size()] == '.';
        const Block* part = target.parameter == nullptr && isPart
                                ? partBlock(kind, *model, material, catalog)
                                : nullptr;
        if (part != nullptr) {
            target.kind = kind;
            target.parameter = part->parameter(key.substr(kind.size() + 1));
        }
    }
}

} // namespace

TextureTarget textureTarget(std::string_view key, const TextureUse& use, const Material& material,
                            const Catalog& catalog) {
    TextureTarget target;
    target.role = textureRole(key);
    if (use.file.empty()) {
        target.whyNot = "It names no file.";
    } else if (use.strength == 0.0) {
        target.whyNot = "Its strength is 0.";
    } else if (target.role == TextureRole::Input) {
        findParameter(target, key, material, catalog);
        if (target.parameter == nullptr) {
            target.whyNot = "The material has no such value now.";
        } else if (target.parameter->textureChannels.empty()) {
            target.whyNot = "The value takes no image.";
        }
    }
    return target;
}

TextureChannel channelOf(const TextureUse& use, const TextureTarget& target) {
    switch (target.role) {
    case TextureRole::Normal:
        return TextureChannel::Color;
    case TextureRole::Height:
        return use.channel == TextureChannel::Auto ? TextureChannel::Red : use.channel;
    case TextureRole::Opacity:
        return use.channel == TextureChannel::Auto ? TextureChannel::Alpha : use.channel;
    default:
        return takes(*target.parameter, use.channel)
                   ? use.channel
                   : channelNamed(target.parameter->textureChannels.front());
    }
}

bool isColorUse(TextureRole role, TextureChannel channel) {
    return role == TextureRole::Input &&
           (channel == TextureChannel::Color || channel == TextureChannel::Alpha);
}

bool isTextured(std::string_view parameterId, const Material& material) {
    const auto found = material.textures.find(parameterId);
    return found != material.textures.end() && !found->second.file.empty() &&
           found->second.strength != 0.0;
}

/// A clear body is seen by what it bends and mirrors.
bool canBeSeen(const Material& material) {
    return material.opacity > 0.0 || material.part(kinds::refraction) != nullptr ||
           isTextured("opacity", material);
}

bool isDrawn(const Object& object) {
    return object.visible && canBeSeen(object.material);
}

bool isTransparent(const Material& material, const Catalog& catalog) {
    return opacityOf(material, catalog) < 1.0 ||
           (isTextured("opacity", material) && !material.textures.find("opacity")->second.cutOut);
}

} // namespace patina
