// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_extras.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/exchange_keys.h"
#include "core/fnv_hash.h"
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

std::string hashOf(const tinygltf::Image& image) {
    return contentHash({reinterpret_cast<const char*>(image.image.data()), image.image.size()});
}

/// Returns what the image of a texture is: its URI, or the hash of its content inside the file;
/// empty for none.
std::string imageOf(int texture, const tinygltf::Model& model) {
    const int source = texture >= 0 && std::size_t(texture) < model.textures.size()
                           ? model.textures[std::size_t(texture)].source
                           : -1;
    if (source < 0 || std::size_t(source) >= model.images.size()) {
        return {};
    }
    const tinygltf::Image& image = model.images[std::size_t(source)];
    return image.uri.empty() ? hashOf(image) : image.uri;
}

std::vector<std::string> imagesOf(const tinygltf::Material& material,
                                  const tinygltf::Model& model) {
    const tinygltf::PbrMetallicRoughness& look = material.pbrMetallicRoughness;
    std::vector<std::string> images;
    for (const int texture : {look.baseColorTexture.index, look.metallicRoughnessTexture.index,
                              material.normalTexture.index, material.emissiveTexture.index}) {
        images.push_back(imageOf(texture, model));
    }
    return images;
}

/// Tells whether a material still has the factors and the images that were written with its preset.
bool isUnchanged(const tinygltf::Material& material, const tinygltf::Model& model,
                 const Json& own) {
    const auto images = own.find(imagesKey); // older files have none
    if (images != own.end() && *images != Json(imagesOf(material, model))) {
        return false;
    }
    const auto written = own.find(writtenKey);
    const std::vector<double> factors = factorsOf(material);
    return written != own.end() && written->is_array() && written->size() == factors.size() &&
           std::equal(factors.begin(), factors.end(), written->begin(),
                      [](double factor, const Json& before) {
                          return before.is_number() &&
                                 std::abs(before.get<double>() - factor) <= sameFactor;
                      });
}

/// Returns an image inside the file that a preset names by its content; nothing for other names and
/// where the file has none that can be read.
std::optional<std::string> imageInside(const std::string& name, const tinygltf::Model& model) {
    const auto found = std::ranges::find_if(model.images, [&name](const tinygltf::Image& image) {
        return isEmbeddedImage(image) && name == insidePrefix + hashOf(image);
    });
    return found == model.images.end() ? std::nullopt : std::optional(embeddedImage(*found));
}

/// Finds the images of a preset and returns them by their keys; nothing where one may not be read
/// or is not there.
std::optional<std::map<std::string, std::string>>
findImages(const Json& preset, const tinygltf::Model& model, MeshFolder& folder) {
    MeshMaterial place;
    const auto textures = preset.find("textures");
    if (textures == preset.end() || !textures->is_object()) {
        return place.images;
    }
    for (const auto& [key, use] : textures->items()) {
        const bool hasFile = use.is_object() && use.contains("file") && use["file"].is_string();
        const std::string name = hasFile ? use["file"].get<std::string>() : std::string();
        if (const auto inside = imageInside(name, model)) {
            place.images[key] = *inside;
        } else if (!hasFile || !addImage(place, key, name, folder)) {
            return std::nullopt;
        }
    }
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
        (*own)[presetKey].is_object() && isUnchanged(from, model, *own)) {
        const Json& preset = (*own)[presetKey];
        if (auto images = findImages(preset, model, folder)) {
            material.presetImages = *std::move(images);
            material.preset = preset.dump(-1, ' ', false, Json::error_handler_t::replace);
        }
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
