// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_materials.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "core/exchange_keys.h"
#include "core/grain_widths.h"
#include "core/image_place.h"
#include "io/gltf_embedded.h"
#include "io/gltf_extras.h"
#include "io/gltf_file.h"
#include "io/material_images.h"
#include "io/material_look.h"
#include "io/mesh_parts.h"

namespace patina {
namespace {

constexpr double usualIndex = 1.5; // of glTF's dielectrics

glm::dvec3 colorOf(const std::vector<double>& numbers, double missing) {
    return numbers.size() < 3 ? glm::dvec3(missing)
                              : glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

/// Returns a number of an array in an extension; `missing` where it has none.
double numberAt(const tinygltf::Value& extension, const char* key, int at, double missing) {
    const tinygltf::Value& array = extension.Get(key);
    return array.IsArray() && std::size_t(at) < array.ArrayLen() && array.Get(at).IsNumber()
               ? array.Get(at).GetNumberAsDouble()
               : missing;
}

/// Tells whether an image is turned by part of a right angle and has two scales, which an image of
/// ours cannot: it scales after it turns.
bool isSheared(const MeshMaterial& material, const std::string& word) {
    const glm::dvec3 scale = material.values.at(word + imageScaleWord);
    const double turn = material.values.at(word + imageTurnWord).x;
    return std::abs(std::abs(scale.x) - std::abs(scale.y)) > 1e-6 &&
           std::abs(std::sin(2.0 * turn)) > 1e-6;
}

/// Says how an image lies, by KHR_texture_transform.
void addPlace(MeshMaterial& material, const std::string& word,
              const tinygltf::ExtensionMap& extensions, LeftOut& left) {
    const auto found = extensions.find("KHR_texture_transform");
    if (found == extensions.end() || !found->second.IsObject()) {
        return;
    }
    const tinygltf::Value& place = found->second;
    const tinygltf::Value& turn = place.Get("rotation");
    material.values[word + imageScaleWord] = {numberAt(place, "scale", 0, 1.0),
                                              numberAt(place, "scale", 1, 1.0), 0.0};
    material.values[word + imageOffsetWord] = {numberAt(place, "offset", 0, 0.0),
                                               numberAt(place, "offset", 1, 0.0), 0.0};
    material.values[word + imageTurnWord] =
        glm::dvec3(turn.IsNumber() ? turn.GetNumberAsDouble() : 0.0);
    if (isSheared(material, word)) {
        left.add(LeftOut::What::ShearedImage, material.name);
    }
}

/// Says what is beyond an image's edge, which is the same along both axes, and how its pixels are
/// put together.
void addSampler(MeshMaterial& material, const std::string& word, int index,
                const tinygltf::Model& model, LeftOut& left) {
    if (index < 0 || std::size_t(index) >= model.samplers.size()) {
        return;
    }
    const tinygltf::Sampler& sampler = model.samplers[std::size_t(index)];
    if (sampler.wrapS != sampler.wrapT) {
        left.add(LeftOut::What::ImageEdge, material.name);
    }
    if (sampler.wrapS != TINYGLTF_TEXTURE_WRAP_REPEAT) {
        const bool isClamped = sampler.wrapS == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
        material.values[word + imageWrapWord] = glm::dvec3(isClamped ? 1.0 : 2.0);
    }
    if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) {
        material.values[word + imageNearestWord] = glm::dvec3(1.0);
    }
}

/// Adds the image of a texture, by its number.
void addTexture(MeshMaterial& material, const char* word, int index,
                const tinygltf::ExtensionMap& extensions, const tinygltf::Model& model,
                MeshFolder& folder, LeftOut& left) {
    if (index < 0 || std::size_t(index) >= model.textures.size()) {
        return;
    }
    const int source = model.textures[std::size_t(index)].source;
    if (source < 0 || std::size_t(source) >= model.images.size()) {
        return;
    }
    const tinygltf::Image& image = model.images[std::size_t(source)];
    if (isEmbeddedImage(image)) {
        material.images[word] = embeddedImage(image);
        addPlace(material, word, extensions, left);
        addSampler(material, word, model.textures[std::size_t(index)].sampler, model, left);
        return;
    }
    if (image.uri.empty() || image.uri.starts_with("data:")) {
        return;
    }
    const std::string uri = withoutEscapes(image.uri);
    if (!addImage(material, word, uri, folder) && !addImage(material, word, image.uri, folder)) {
        left.add(LeftOut::What::MissingImage, fileNameIn(uri));
        return;
    }
    addPlace(material, word, extensions, left);
    addSampler(material, word, model.textures[std::size_t(index)].sampler, model, left);
}

/// Returns a value of an extension of a material; null where it has none.
const tinygltf::Value* valueIn(const tinygltf::Material& material, const char* extension,
                               const char* key) {
    const auto found = material.extensions.find(extension);
    return found != material.extensions.end() && found->second.IsObject() && found->second.Has(key)
               ? &found->second.Get(key)
               : nullptr;
}

double numberIn(const tinygltf::Material& material, const char* extension, const char* key,
                double missing) {
    const tinygltf::Value* value = valueIn(material, extension, key);
    return value != nullptr && value->IsNumber() ? value->GetNumberAsDouble() : missing;
}

glm::dvec3 colorIn(const tinygltf::Material& material, const char* extension, const char* key) {
    const tinygltf::Value* value = valueIn(material, extension, key);
    glm::dvec3 color(1.0);
    for (int i = 0; value != nullptr && value->IsArray() && value->ArrayLen() == 3 && i < 3; ++i) {
        color[i] = value->Get(i).IsNumber() ? value->Get(i).GetNumberAsDouble() : 1.0;
    }
    return color;
}

/// Gives a dielectric the reflectance that KHR_materials_ior and KHR_materials_specular say; one
/// without any is matte.
void setReflectance(MeshMaterial& material, const tinygltf::Material& from) {
    const double factor = numberIn(from, "KHR_materials_specular", "specularFactor", 1.0);
    if (factor <= 0.0 && material.isDielectric()) {
        material.look = "matte";
        material.values.erase("f0");
        material.values.erase("alpha");
        return;
    }
    const glm::dvec3 tint = colorIn(from, "KHR_materials_specular", "specularColorFactor");
    const double ior = numberIn(from, "KHR_materials_ior", "ior", usualIndex);
    const double root = (ior - 1.0) / (ior + 1.0);
    material.values["f0"] =
        glm::clamp(factor * glm::min(root * root * tint, glm::dvec3(1.0)), 0.0, 1.0);
}

double transmissionOf(const tinygltf::Material& material) {
    return glm::clamp(numberIn(material, "KHR_materials_transmission", "transmissionFactor", 0.0),
                      0.0, 1.0);
}

/// Gives a material the transmission of KHR_materials_transmission, and the inside that
/// KHR_materials_volume and KHR_materials_dispersion say. Without a volume it is a wall.
void setTransmission(MeshMaterial& material, const glm::dvec3& base,
                     const tinygltf::Material& from) {
    const double share = transmissionOf(from);
    if (share <= 0.0) {
        return;
    }
    material.values["transmission"] = glm::clamp(base, 0.0, 1.0);
    material.values["opacity"] = glm::dvec3(1.0 - share);
    if (numberIn(from, "KHR_materials_volume", "thicknessFactor", 0.0) <= 0.0) {
        material.values["thickness"] = glm::dvec3(0.0);
        return;
    }
    const double distance = numberIn(from, "KHR_materials_volume", "attenuationDistance", 0.0);
    if (distance > 0.0) { // it absorbs nothing otherwise
        material.values["attenuation.color"] =
            colorIn(from, "KHR_materials_volume", "attenuationColor");
        material.values["attenuation.distance"] = glm::dvec3(distance);
    }
    material.values["dispersion"] =
        glm::dvec3(numberIn(from, "KHR_materials_dispersion", "dispersion", 0.0));
}

/// Gives a highlight the grain of KHR_materials_anisotropy, whose direction is that in which it is
/// long: the width there goes from alpha to 1 by the square of the strength.
void setGrain(MeshMaterial& material, const tinygltf::Material& from, LeftOut& left) {
    constexpr const char* extension = "KHR_materials_anisotropy";
    if (!from.extensions.contains(extension) || material.look == "matte") {
        return;
    }
    const double strength =
        glm::clamp(numberIn(from, extension, "anisotropyStrength", 0.0), 0.0, 1.0);
    const double alpha = material.values["alpha"].x;
    const GrainShape shape = shapeOf({alpha + (1.0 - alpha) * strength * strength, alpha});
    if (shape.anisotropy > 1.0 + 1e-6) {
        left.add(LeftOut::What::Anisotropy, material.name);
    }
    material.look = "grained-" + material.look;
    material.values["alpha"] = glm::dvec3(shape.alpha);
    material.values["anisotropy"] = glm::dvec3(std::min(shape.anisotropy, 1.0));
    material.values["grain"] =
        glm::dvec3(grainAcross(numberIn(from, extension, "anisotropyRotation", 0.0)));
}

/// Adds the image of a texture of which one channel counts.
void addNumbers(MeshMaterial& material, const char* word, int channel,
                const tinygltf::TextureInfo& texture, const tinygltf::Model& model,
                MeshFolder& folder, LeftOut& left) {
    addTexture(material, word, texture.index, texture.extensions, model, folder, left);
    material.values[std::string(word) + imageChannelWord] = glm::dvec3(double(channel));
}

MeshMaterial materialFrom(const tinygltf::Material& from, const tinygltf::Model& model,
                          MeshFolder& folder, LeftOut& left) {
    MeshMaterial material;
    material.name = from.name;
    const tinygltf::PbrMetallicRoughness& look = from.pbrMetallicRoughness;
    const auto setLook = isMixed(from, model) ? lookMixed : lookMetallicRough;
    setLook(material, colorOf(look.baseColorFactor, 1.0), look.metallicFactor,
            look.roughnessFactor);
    if (!material.isMetal() && (from.extensions.contains("KHR_materials_ior") ||
                                from.extensions.contains("KHR_materials_specular"))) {
        setReflectance(material, from);
    }
    setGrain(material, from, left);
    addTexture(material, material.isMetal() ? "f0" : "diffuse", look.baseColorTexture.index,
               look.baseColorTexture.extensions, model, folder, left);
    if (!material.hasGrain() && material.look != "matte") {
        addNumbers(material, "alpha", 1, look.metallicRoughnessTexture, model, folder, left);
        material.values[std::string("alpha") + imageRootWord] = glm::dvec3(1.0);
    }
    if (material.hasMetalness() && !isRoughnessAlone(model, look)) {
        addNumbers(material, "metalness", 2, look.metallicRoughnessTexture, model, folder, left);
    }
    addTexture(material, "normal", from.normalTexture.index, from.normalTexture.extensions, model,
               folder, left);
    addTexture(material, "emissive", from.emissiveTexture.index, from.emissiveTexture.extensions,
               model, folder, left);
    const double strength =
        numberIn(from, "KHR_materials_emissive_strength", "emissiveStrength", 1.0);
    material.values["emissive"] =
        glm::clamp(colorOf(from.emissiveFactor, 0.0), 0.0, 1.0) * std::max(strength, 0.0);
    if (from.alphaMode == "BLEND" && look.baseColorFactor.size() == 4) {
        material.values["opacity"] = glm::dvec3(glm::clamp(look.baseColorFactor[3], 0.0, 1.0));
    }
    if (!material.isMetal()) {
        setTransmission(material, colorOf(look.baseColorFactor, 1.0), from);
    }
    addExtras(material, from, model, folder);
    return material;
}

} // namespace

bool isMixed(const tinygltf::Material& material, const tinygltf::Model& model) {
    const tinygltf::PbrMetallicRoughness& look = material.pbrMetallicRoughness;
    if (look.metallicFactor <= 0.0 || transmissionOf(material) > 0.0 ||
        material.extensions.contains("KHR_materials_anisotropy")) {
        return false;
    }
    const bool hasImage = look.metallicRoughnessTexture.index >= 0;
    return look.metallicFactor < 1.0 || (hasImage && !isRoughnessAlone(model, look));
}

bool isRoughnessAlone(const tinygltf::Model& model, const tinygltf::PbrMetallicRoughness& look) {
    const int index = look.metallicRoughnessTexture.index;
    if (index < 0 || std::size_t(index) >= model.textures.size()) {
        return false;
    }
    const int source = model.textures[std::size_t(index)].source;
    return source >= 0 && std::size_t(source) < model.images.size() &&
           model.images[std::size_t(source)].name == roughnessAlone;
}

std::vector<MeshMaterial> materialsFrom(const tinygltf::Model& model, MeshFolder& folder,
                                        LeftOut& left) {
    std::vector<MeshMaterial> materials;
    for (const tinygltf::Material& material : model.materials) {
        materials.push_back(materialFrom(material, model, folder, left));
    }
    nameUniquely(materials);
    return materials;
}

} // namespace patina
