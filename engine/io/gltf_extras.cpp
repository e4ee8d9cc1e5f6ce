// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_extras.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/exchange_keys.h"
#include "io/gltf_embedded.h"
#include "io/gltf_extensions.h"
#include "io/material_images.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::size_t maxForeignBytes = 65536;
constexpr double sameFactor = 1e-5; // is what a program may round that only copies

Json objectIn(const std::string& text) {
    Json json = Json::parse(text, nullptr, false);
    return json.is_object() ? json : Json::object();
}

std::vector<double> factorsOf(const tinygltf::Material& material) {
    const tinygltf::PbrMetallicRoughness& look = material.pbrMetallicRoughness;
    std::vector<double> factors = look.baseColorFactor;
    factors.insert(factors.end(), material.emissiveFactor.begin(), material.emissiveFactor.end());
    factors.insert(factors.end(), {look.metallicFactor, look.roughnessFactor});
    return factors;
}

/// Tells whether a material still has the factors that were written with its preset.
bool isUnchanged(const tinygltf::Material& material, const Json& own) {
    const auto written = own.find(writtenKey);
    const std::vector<double> factors = factorsOf(material);
    return written != own.end() && written->is_array() && written->size() == factors.size() &&
           std::equal(factors.begin(), factors.end(), written->begin(),
                      [](double factor, const Json& before) {
                          return before.is_number() &&
                                 std::abs(before.get<double>() - factor) <= sameFactor;
                      });
}

/// Returns an image inside the file that a preset names by its number; nothing for other names and
/// where the file has none that can be read.
std::optional<std::string> imageInside(const std::string& name, const tinygltf::Model& model) {
    const std::string_view prefix = imageNumberPrefix;
    std::size_t number = model.images.size();
    if (name.starts_with(prefix)) {
        std::from_chars(name.data() + prefix.size(), name.data() + name.size(), number);
    }
    return number < model.images.size() && isEmbeddedImage(model.images[number])
               ? std::optional(embeddedImage(model.images[number]))
               : std::nullopt;
}

/// Finds the images of a preset, and leaves out of it those that may not be read. Returns them by
/// their keys.
std::map<std::string, std::string> findImages(Json& preset, const tinygltf::Model& model,
                                              MeshFolder& folder) {
    MeshMaterial place;
    const auto textures = preset.find("textures");
    if (textures == preset.end() || !textures->is_object()) {
        return {};
    }
    Json found = Json::object();
    for (const auto& [key, use] : textures->items()) {
        const bool hasFile = use.is_object() && use.contains("file") && use["file"].is_string();
        const std::string name = hasFile ? use["file"].get<std::string>() : std::string();
        if (const auto inside = imageInside(name, model)) {
            place.images[key] = *inside;
            found[key] = use;
        } else if (hasFile && addImage(place, key, name, folder)) {
            found[key] = use;
        }
    }
    *textures = std::move(found);
    return place.images;
}

/// Tells whether a value names a texture of the file by its number, which another file has not.
bool namesTexture(const Json& value) {
    return value.is_structured() &&
           (value.contains("index") ||
            std::ranges::any_of(value, [](const Json& each) { return namesTexture(each); }));
}

Json foreignIn(const tinygltf::Material& material) {
    const Json extensions = objectIn(material.extensions_json_string);
    const Json extras = objectIn(material.extras_json_string);
    Json foreign = Json::object();
    for (const auto& [name, extension] : extensions.items()) {
        if (!isReadExtension(name) && !namesTexture(extension)) {
            foreign["extensions"][name] = extension;
        }
    }
    for (const auto& [key, value] : extras.items()) {
        if (key != ownExtras) {
            foreign["extras"][key] = value;
        }
    }
    return foreign;
}

} // namespace

void addExtras(MeshMaterial& material, const tinygltf::Material& from, const tinygltf::Model& model,
               MeshFolder& folder) {
    Json extras = objectIn(from.extras_json_string);
    if (const auto own = extras.find(ownExtras);
        own != extras.end() && own->is_object() && own->contains(presetKey) &&
        (*own)[presetKey].is_object() && isUnchanged(from, *own)) {
        Json& preset = (*own)[presetKey];
        material.presetImages = findImages(preset, model, folder);
        material.preset = preset.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    const Json foreign = foreignIn(from);
    const std::string text = foreign.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (!foreign.empty() && text.size() <= maxForeignBytes) {
        material.foreign = text;
    }
}

bool hasForeignExtras(const tinygltf::Material& material) {
    if (!material.extras.IsObject()) {
        return material.extras.Type() != tinygltf::NULL_TYPE;
    }
    const std::vector<std::string> keys = material.extras.Keys();
    return std::ranges::any_of(keys, [](const std::string& key) { return key != ownExtras; });
}

} // namespace patina
