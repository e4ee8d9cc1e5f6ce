// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/mesh_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "catalog/json_text.h"
#include "core/exchange_keys.h"
#include "core/image_place.h"
#include "core/number_text.h"
#include "material/block_assignment.h"
#include "material/material_assignment.h"
#include "material/preset_file.h"
#include "material/texture_place.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// Holds a look with the block beside the model that states it.
struct PartLook {
    const Block* block = nullptr;
    MeshLook look;
};

std::filesystem::path looksFile() {
    return dataFolder() / "presets" / "mesh-looks.json";
}

MeshLook lookFrom(const Json& json) {
    return {json.at("look").get<std::string>(), json.value("set", std::vector<std::string>()),
            json.at("values").get<std::map<std::string, std::string>>()};
}

/// Returns the assignment of a value, brought into the range of its parameter.
std::string assignmentOf(const std::string& id, const glm::dvec3& value, const Parameter& to) {
    const glm::dvec3 held = glm::clamp(value, to.min, to.max);
    return to.type == ParameterType::Color ? fmt::format("{}={},{},{}", id, fullText(held.x),
                                                         fullText(held.y), fullText(held.z))
                                           : fmt::format("{}={}", id, fullText(held.x));
}

glm::dvec3 valueOf(const MeshMaterial& from, const std::string& word, const glm::dvec3& missing) {
    const auto found = from.values.find(word);
    return found == from.values.end() ? missing : found->second;
}

/// Lets an image go on beyond its edge, and be smooth, as the file says.
void setSampler(TextureUse& use, const MeshMaterial& from, const std::string& word) {
    const double edge = valueOf(from, word + imageWrapWord, {}).x;
    use.wrap = edge == 1.0   ? TextureWrap::Clamp
               : edge == 2.0 ? TextureWrap::Mirror
                             : TextureWrap::Repeat;
    if (from.values.contains(word + imageNearestWord)) {
        use.filter = TextureFilter::Nearest;
    }
}

/// Takes an image's numbers as the file says, whose other channels are of something else.
void setNumbers(TextureUse& use, const MeshMaterial& from, const std::string& word) {
    constexpr std::array channels{TextureChannel::Red, TextureChannel::Green, TextureChannel::Blue,
                                  TextureChannel::Alpha};
    if (const auto channel = from.values.find(word + imageChannelWord);
        channel != from.values.end()) {
        use.channel = channels[static_cast<std::size_t>(
            glm::clamp(channel->second.x, 0.0, double(channels.size() - 1)))];
        use.colorSpace = from.values.contains(word + imageRootWord) ? TextureColorSpace::Roots
                                                                    : TextureColorSpace::Linear;
    }
}

/// Places an image as the file says, whose coordinates begin at the top. It scales before it turns,
/// so that an image that is turned by part of a right angle has one scale.
void placeImage(TextureUse& use, const MeshMaterial& from, const std::string& word) {
    if (!from.values.contains(word + imageScaleWord)) {
        return;
    }
    const double turn = valueOf(from, word + imageTurnWord, {}).x;
    use.scale = valueOf(from, word + imageScaleWord, glm::dvec3(1.0));
    if (std::abs(std::sin(turn)) > std::abs(std::cos(turn))) {
        std::swap(use.scale.x, use.scale.y);
    }
    use.rotation = std::remainder(-glm::degrees(turn), 360.0);
    use.offset = {};
    const TexturePlace unmoved = texturePlace(use);
    const glm::dvec3 offset = valueOf(from, word + imageOffsetWord, {});
    use.offset = {offset.x - unmoved.across.y - unmoved.across.z,
                  1.0 - offset.y - unmoved.up.y - unmoved.up.z};
}

/// Lays the images on the surface and on the parameters that have the values of the same words. An
/// image on a colour is multiplied with it, as all formats do, unless nothing would be left.
void layImages(Material& material, const MeshMaterial& from, const MeshLook& look) {
    for (const auto& [word, file] : from.images) {
        const auto parameter = look.values.find(word);
        const std::string key = parameter == look.values.end() ? word : parameter->second;
        if (parameter == look.values.end() && textureRole(key) == TextureRole::Input) {
            continue;
        }
        TextureUse use = textureUse(key, file);
        const auto value = from.values.find(word);
        const bool isVisible = value != from.values.end() && value->second != glm::dvec3(0.0);
        if (textureRole(key) == TextureRole::Input && isVisible) {
            use.mode = TextureMode::Multiply;
        }
        placeImage(use, from, word);
        setSampler(use, from, word);
        setNumbers(use, from, word);
        material.textures[key] = use;
    }
}

} // namespace

Result<std::vector<MeshLook>> meshLooksOf(const Block& model) {
    const auto document = readJson(model.descriptorFile);
    if (!document) {
        return tl::unexpected(document.error());
    }
    std::vector<MeshLook> looks;
    try {
        for (const Json& look : document->value.value("looks", Json::array())) {
            looks.push_back(lookFrom(look));
        }
    } catch (const Json::exception& problem) {
        return tl::unexpected(document->error("/looks", problem.what()));
    }
    return looks;
}

Result<Material> ModelLook::start(const Catalog& catalog) const {
    Material material = defaultMaterial(*model);
    for (const std::string& assignment : look.assignments) {
        if (const auto done = assignInMaterial(material, assignment, catalog); !done) {
            return tl::unexpected(done.error());
        }
    }
    return material;
}

Result<ModelLook> importedLook(const std::string& look, const Catalog& catalog) {
    const auto document = readJson(looksFile());
    if (!document) {
        return tl::unexpected(document.error());
    }
    const Json& all = document->value;
    const auto id = all.is_object() ? all.find(look) : all.end();
    if (id == all.end() || !id->is_string()) {
        return tl::unexpected(
            document->error("", fmt::format("there is no model for the look \"{}\"", look)));
    }
    const auto model = knownBlock(catalog, kinds::models, id->get<std::string>());
    if (!model) {
        return tl::unexpected(model.error());
    }
    const auto looks = meshLooksOf(**model);
    if (!looks) {
        return tl::unexpected(looks.error());
    }
    const auto stated = std::ranges::find(*looks, look, &MeshLook::look);
    if (stated == looks->end()) {
        return failure(
            fmt::format("the model \"{}\" does not state the look \"{}\"", (*model)->id, look));
    }
    return ModelLook{*model, *stated};
}

namespace {

/// Returns the block that refracts what passes, by presets/mesh-looks.json, with its look.
Result<PartLook> importedTransmission(bool isWall, const Catalog& catalog) {
    const auto document = readJson(looksFile());
    if (!document) {
        return tl::unexpected(document.error());
    }
    const char* key = isWall ? "transmission of a wall" : "transmission";
    const auto block = knownBlock(catalog, kinds::refraction, document->value.value(key, ""));
    if (!block) {
        return tl::unexpected(block.error());
    }
    const auto looks = meshLooksOf(**block);
    if (!looks) {
        return tl::unexpected(looks.error());
    }
    const auto stated = std::ranges::find(*looks, "transmission", &MeshLook::look);
    if (stated == looks->end()) {
        return failure(
            fmt::format("the block \"{}\" does not state the look \"transmission\"", (*block)->id));
    }
    return PartLook{*block, *stated};
}

/// Makes the material as transparent as the file says.
Result<void> addTransmission(Material& material, const MeshMaterial& from, const Catalog& catalog) {
    if (!from.values.contains("transmission")) {
        return {};
    }
    const auto part = importedTransmission(from.values.contains("thickness"), catalog);
    if (!part) {
        return tl::unexpected(part.error());
    }
    const std::string kind(kinds::refraction);
    Result<void> done = choosePart(material, kind, part->block->id, catalog).map([](bool) {});
    for (const auto& [word, id] : part->look.values) {
        const auto value = from.values.find(word);
        const Parameter* parameter = part->block->parameter(id);
        if (done && value != from.values.end() && parameter != nullptr) {
            done = assignInMaterial(
                material, assignmentOf(kind + '.' + id, value->second, *parameter), catalog);
        }
    }
    return done;
}

/// Returns the material that was exported as this one; nothing where the file has none that can be
/// read, or one of a model that is not here. Only images may be read for it that the reader of the
/// file has found.
std::optional<Material> ownMaterial(const MeshMaterial& from, const Catalog& catalog) {
    auto document = parseJson(from.preset, std::string());
    if (!document || !document->value.is_object()) {
        return std::nullopt;
    }
    ReadingRights rights;
    Json textures = Json::object();
    const Json named = document->value.value("textures", Json::object());
    for (const auto& [key, file] : from.presetImages) {
        rights.allowed.insert(file);
        const Json use = named.is_object() ? named.value(key, Json::object()) : Json::object();
        textures[key] = use.is_object() ? use : Json::object();
        textures[key]["file"] = file;
    }
    document->value["textures"] = std::move(textures);
    auto reading = materialFromJson(*document, {}, catalog, rights);
    const bool isKnown =
        reading && catalog.find(kinds::models, reading->material.model.id) != nullptr;
    return isKnown ? std::optional(std::move(reading->material)) : std::nullopt;
}

/// Keeps what only other programs know of a material, for an export to the same format.
void keepForeign(Material& material, const MeshMaterial& from) {
    if (const auto foreign = parseJson(from.foreign, std::string())) {
        material.extras[foreignKey] = foreign->value;
    }
}

} // namespace

Result<Material> materialOf(const MeshMaterial& from, const Catalog& catalog) {
    if (auto own = ownMaterial(from, catalog)) {
        keepForeign(*own, from);
        return *std::move(own);
    }
    const auto imported = importedLook(from.look, catalog);
    if (!imported) {
        return tl::unexpected(imported.error());
    }
    auto started = imported->start(catalog);
    if (!started) {
        return started;
    }
    Material material = std::move(*started);
    material.name = from.name;
    Result<void> done;
    for (const auto& [word, id] : imported->look.values) {
        const auto value = from.values.find(word);
        const Parameter* parameter = parameterIn(material, id, catalog);
        if (value != from.values.end() && parameter != nullptr) {
            done = done.and_then([&, &id = id] {
                return assignInMaterial(material, assignmentOf(id, value->second, *parameter),
                                        catalog);
            });
        }
    }
    done = done.and_then([&] { return addTransmission(material, from, catalog); });
    if (!done) {
        return tl::unexpected(done.error());
    }
    if (const auto opacity = from.values.find("opacity"); opacity != from.values.end()) {
        material.opacity = opacity->second.x;
    }
    layImages(material, from, imported->look);
    keepForeign(material, from);
    return material;
}

} // namespace patina
