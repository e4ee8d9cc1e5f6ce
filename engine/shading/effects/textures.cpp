// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/textures.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "catalog/combing_role.h"
#include "material/texture_place.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/program/given_value.h"

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

/// Returns the block that the model's slot of this kind calls, the Fresnel term that blends the
/// sum, or the shells.
const Block* partBlock(std::string_view kind, const Block& model, const Material& material,
                       const Catalog& catalog) {
    if (const Slot* slot = model.slot(kind)) {
        return slotChoice(*slot, material, catalog).block;
    }
    const BlockValues* part = material.part(kind);
    const bool isCalled = kind == kinds::fresnel || kind == kinds::shells;
    return part != nullptr && isCalled ? catalog.find(kind, part->id) : nullptr;
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

/// Returns the key of the images of a role that changes no parameter.
std::string_view keyOf(TextureRole role) {
    constexpr std::array<std::string_view, 3> keys{"normal", "height", "opacity"};
    return *std::ranges::find(keys, role, textureRole);
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

/// Alpha that was not chosen is the grey of an image that has none.
const char* channelText(const BoundTexture& texture, bool isChosen) {
    switch (texture.channel) {
    case TextureChannel::Red:
        return "red";
    case TextureChannel::Green:
        return "green";
    case TextureChannel::Blue:
        return "blue";
    case TextureChannel::Alpha:
        return isChosen || texture.isOfVertices ? "alpha" : "alpha, or grey without one";
    default:
        return "colour";
    }
}

std::string detailOf(const BoundTexture& texture, const EffectSubject* subject) {
    if (texture.role == TextureRole::Normal || texture.role == TextureRole::Height) {
        return {};
    }
    const TextureUse* use = subject == nullptr ? nullptr : texture.in(*subject->material);
    const bool isChosen = use == nullptr || use->channel == texture.channel;
    return fmt::format("{}{}, {}{}", texture.isOfVertices ? "vertex colours: " : "",
                       channelText(texture, isChosen), modeText(texture.mode),
                       texture.cutOut      ? ", cut out"
                       : texture.isOfRoots ? ", squared"
                                           : "");
}

/// Returns a parameter of the table that a level reads which an image changes; null: there is none.
const Parameter* texturedInput(const EffectSet& set, const Block& block, const EnumValue& level) {
    const BlockTable* table = block.table(level.table);
    if (table == nullptr) {
        return nullptr;
    }
    for (const std::string& id : table->of) {
        const bool hasImage = std::ranges::any_of(set.textures, [&](const BoundTexture& image) {
            return image.role == TextureRole::Input && image.kind == block.kind &&
                   image.parameter->id == id;
        });
        if (hasImage) {
            return block.parameter(id);
        }
    }
    return nullptr;
}

/// Returns all whose values an image may change.
std::vector<const BlockUse*> usesOf(const EffectSet& set) {
    std::vector<const BlockUse*> uses;
    if (set.model) {
        uses.push_back(&*set.model);
    }
    for (const BlockUse& slot : set.slots) {
        uses.push_back(&slot);
    }
    if (set.blend) {
        uses.push_back(&*set.blend);
    }
    if (set.shells) {
        uses.push_back(&*set.shells);
    }
    return uses;
}

/// Lists the tables that the material chooses and an image rules out.
void listComputedTables(LeftOutListing& listing, const BlockUse& use, const Material& material,
                        const EffectSet& set) {
    const Block& block = use.block();
    for (const AccuracyChoice& choice : block.accuracy) {
        if (choice.values.empty()) {
            continue;
        }
        const EnumValue& wanted = choice.values[chosenIndex(choice, material.accuracy)];
        if (const Parameter* changed = texturedInput(set, block, wanted)) {
            listing.add("table/" + wanted.table,
                        fmt::format("An image drives {}, so {} is computed exactly.",
                                    changed->label, choice.label));
        }
    }
}

/// Packs where a texture is, how strong, and from which opacity on it cuts nothing out.
void packTexture(std::span<glm::vec4> out, const TextureUse& use, TextureRole role) {
    const TexturePlace place = texturePlace(use);
    const bool isShare = role == TextureRole::Input || role == TextureRole::Opacity;
    const double strength = isShare ? std::clamp(use.strength, 0.0, 1.0) : use.strength;
    out[0] = glm::vec4(place.across, strength);
    out[1] = glm::vec4(place.up, use.threshold);
}

void packTextures(std::span<glm::vec4> out, const Material& material, const EffectSet& set) {
    for (std::size_t i = 0; i < set.textures.size(); ++i) {
        const BoundTexture& image = set.textures[i];
        const TextureUse* use = image.in(material);
        static const TextureUse nothing = [] {
            TextureUse none;
            none.strength = 0.0;
            return none;
        }();
        packTexture(out.subspan(i * ObjectLayout::vec4sPerTexture, ObjectLayout::vec4sPerTexture),
                    use == nullptr ? nothing : *use, image.role);
    }
}

/// Returns how many images may be bound before this one is left out: one fewer where the image of
/// the opacity comes behind it, since shadows and the order of what is transparent go by that.
std::size_t roomFor(std::string_view key, const Material& material) {
    constexpr std::string_view shape = "opacity";
    return maxTextures - (key < shape && isTextured(shape, material) ? 1 : 0);
}

} // namespace

TextureTarget textureTarget(std::string_view key, const TextureUse& use, const Material& material,
                            const Catalog& catalog) {
    TextureTarget target;
    target.role = textureRole(key);
    if (use.file.empty()) {
        target.whyNot = "It names no file.";
    } else if (!use.enabled) {
        target.whyNot = "It is switched off.";
    } else if (use.strength == 0.0) {
        target.whyNot = "Its strength is 0.";
    } else if (isVertexColors(use.file) && target.role != TextureRole::Input) {
        target.whyNot = "Vertex colours are no image of the surface's shape.";
    } else if (target.role == TextureRole::Input) {
        findParameter(target, key, material, catalog);
        if (target.parameter == nullptr) {
            target.whyNot = "The material has no such value now.";
        } else if (target.parameter->textureChannels.empty()) {
            target.whyNot = "The value takes no image.";
        } else if (isVertexColors(use.file) && target.parameter->role == roles::combing) {
            target.whyNot = "Vertex colours are no directions.";
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
           found->second.enabled && found->second.strength != 0.0 &&
           (!isVertexColors(found->second.file) || textureRole(parameterId) == TextureRole::Input);
}

std::string BoundTexture::key() const {
    if (parameter == nullptr) {
        return std::string(keyOf(role));
    }
    return kind == kinds::models ? parameter->id : std::string(kind) + '.' + parameter->id;
}

bool BoundTexture::hasKey(std::string_view key) const {
    if (parameter == nullptr) {
        return textureRole(key) == role;
    }
    if (kind == kinds::models) {
        return key == parameter->id;
    }
    return key.size() == kind.size() + 1 + parameter->id.size() && key.starts_with(kind) &&
           key[kind.size()] == '.' && key.ends_with(parameter->id);
}

const TextureUse* BoundTexture::in(const Material& material) const {
    const auto found = std::ranges::find_if(
        material.textures, [this](const auto& texture) { return hasKey(texture.first); });
    return found == material.textures.end() ? nullptr : &found->second;
}

bool BoundTexture::isColor() const {
    return parameter != nullptr && infoOf(parameter->type).isColor;
}

BoundTexture boundTexture(const TextureUse& use, const TextureTarget& target) {
    return {target.role,
            target.kind,
            target.parameter,
            channelOf(use, target),
            use.mode,
            target.role == TextureRole::Opacity && use.cutOut,
            isVertexColors(use.file),
            target.role == TextureRole::Input && use.colorSpace == TextureColorSpace::Roots &&
                !isVertexColors(use.file)};
}

void TexturesEffect::choose(const MaterialSubject& subject, const EffectSet& set) {
    textures.clear();
    if (!set.model) {
        return;
    }
    for (const auto& [key, use] : subject.material.textures) {
        const TextureTarget target = textureTarget(key, use, subject.material, subject.catalog);
        if (target.whyNot == nullptr && textures.size() < roomFor(key, subject.material)) {
            textures.push_back(boundTexture(use, target));
        }
    }
}

void TexturesEffect::addTo(ChoiceHash& hash) const {
    hash.add(std::uint64_t(textures.size()));
    for (const BoundTexture& texture : textures) {
        hash.add(static_cast<std::uint64_t>(texture.role));
        hash.add(texture.kind);
        hash.add(texture.parameter == nullptr ? std::string_view()
                                              : std::string_view(texture.parameter->id));
        hash.add(static_cast<std::uint64_t>(texture.channel));
        hash.add(static_cast<std::uint64_t>(texture.mode));
        hash.add(texture.cutOut);
        hash.add(texture.isOfVertices);
        hash.add(texture.isOfRoots);
    }
}

void TexturesEffect::list(EffectListing& listing, const EffectSet&) const {
    for (const BoundTexture& texture : textures) {
        listing.add("texture/" + texture.key(), detailOf(texture, listing.subject()),
                    always(texture.isOfVertices ? "The mesh's vertex colours drive it."
                                                : "An image is bound to it."));
    }
}

void TexturesEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    const Material* material = listing.subject().material;
    if (material == nullptr) {
        return;
    }
    std::size_t count = 0;
    for (const auto& [key, use] : material->textures) {
        const TextureTarget target = textureTarget(key, use, *material, listing.subject().catalog);
        if (target.whyNot != nullptr) {
            listing.add("texture/" + key, target.whyNot);
        } else if (!set.model) {
            listing.add("texture/" + key, "The model is not known.");
        } else if (count < roomFor(key, *material)) {
            ++count;
        } else {
            listing.add("texture/" + key,
                        fmt::format("A material shows {} images at most.", maxTextures));
        }
    }
    for (const BlockUse* use : usesOf(set)) {
        listComputedTables(listing, *use, *material, set);
    }
}

void TexturesEffect::place(ObjectLayout& layout, const EffectSet&) const {
    layout.firstTexture = layout.vec4s;
    layout.place(packTextures, ObjectLayout::vec4sPerTexture * static_cast<int>(textures.size()),
                 layout.vec4s);
}

std::string_view TexturesEffect::whyPerPixel(const EffectSet&) const {
    return !textures.empty() ? "images change the surface between its corners."
                             : std::string_view();
}

bool TexturesEffect::readsVertexColors() const {
    return std::ranges::any_of(textures, &BoundTexture::isOfVertices);
}

void TexturesEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind != "texture") {
        return;
    }
    for (Object& object : scene.objects) {
        object.material.textures.erase(std::string(effect.id));
    }
}

void makeTexturedExact(BlockUse& use, const EffectSet& set) {
    for (const AccuracyChoice& choice : use.block().accuracy) {
        if (!choice.values.empty() && texturedInput(set, use.block(), use.level(choice))) {
            use.setExact(choice);
        }
    }
}

} // namespace patina
