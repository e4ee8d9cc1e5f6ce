// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_left_out.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

#include "io/gltf_embedded.h"
#include "io/gltf_extensions.h"
#include "io/gltf_extras.h"
#include "io/gltf_materials.h"

namespace patina {
namespace {

using What = LeftOut::What;

constexpr std::string_view lightsExtension = "KHR_lights_punctual"; ///< lights are told by name

template <class Element>
void addAll(LeftOut& left, What what, const std::vector<Element>& elements) {
    for (const Element& element : elements) {
        left.add(what, element.name);
    }
}

void addMeshes(LeftOut& left, const tinygltf::Model& model) {
    for (const tinygltf::Mesh& mesh : model.meshes) {
        const auto has = [&mesh](auto question) {
            return std::ranges::any_of(mesh.primitives, question);
        };
        if (has([](const tinygltf::Primitive& each) { return !each.targets.empty(); })) {
            left.add(What::MorphTargets, mesh.name);
        }
        if (has([](const tinygltf::Primitive& each) {
                return each.mode >= TINYGLTF_MODE_POINTS && each.mode <= TINYGLTF_MODE_LINE_STRIP;
            })) {
            left.add(What::PointsAndLines, mesh.name);
        }
    }
}

void addExtensions(LeftOut& left, const tinygltf::Model& model) {
    for (const std::string& name : model.extensionsUsed) {
        const bool isTold = name == lightsExtension && !model.lights.empty();
        if (!isTold && !isReadExtension(name)) {
            left.add(isOfMaterials(name) ? What::MaterialExtension : What::Extension, name);
        }
    }
}

/// Adds the image of a texture, if there is one, as "roughness of Brick.png".
void addTexture(LeftOut& left, const tinygltf::Model& model, const char* use, int index,
                bool isRead) {
    if (index < 0 || std::size_t(index) >= model.textures.size()) {
        return;
    }
    const int source = model.textures[std::size_t(index)].source;
    if (source < 0 || std::size_t(source) >= model.images.size()) {
        left.add(What::Image, use); // an extension has it
        return;
    }
    const tinygltf::Image& image = model.images[std::size_t(source)];
    const bool isInside = image.uri.empty() || image.uri.starts_with("data:");
    if (!isRead || (isInside && !isEmbeddedImage(image))) {
        const std::string name =
            isInside ? image.name : std::filesystem::path(image.uri).filename().string();
        left.add(What::Image, name.empty() ? use : use + (" of " + name));
    }
}

/// Adds an image that an extension has, under a key.
void addExtensionTexture(LeftOut& left, const tinygltf::Model& model,
                         const tinygltf::Material& material, const char* extension, const char* key,
                         const char* use) {
    const auto found = material.extensions.find(extension);
    if (found != material.extensions.end() && found->second.IsObject() && found->second.Has(key)) {
        const tinygltf::Value& texture = found->second.Get(key);
        if (texture.IsObject() && texture.Has("index") && texture.Get("index").IsInt()) {
            addTexture(left, model, use, texture.Get("index").GetNumberAsInt(), false);
        }
    }
}

/// Adds what materials have that is not read.
void addMaterials(LeftOut& left, const tinygltf::Model& model) {
    for (const tinygltf::Material& material : model.materials) {
        const tinygltf::PbrMetallicRoughness& look = material.pbrMetallicRoughness;
        if (hasForeignExtras(material)) {
            left.add(What::MaterialExtras, material.name);
        }
        addTexture(left, model, "colour", look.baseColorTexture.index, true);
        const bool hasGrain = material.extensions.contains("KHR_materials_anisotropy");
        const bool isWhole =
            look.metallicFactor <= 0.0 || isMixed(material, model) || isRoughnessAlone(model, look);
        addTexture(left, model, isWhole ? "roughness" : "roughness or metalness",
                   look.metallicRoughnessTexture.index, !hasGrain && isWhole);
        addTexture(left, model, "normals", material.normalTexture.index, true);
        addTexture(left, model, "occlusion", material.occlusionTexture.index, false);
        addTexture(left, model, "glow", material.emissiveTexture.index, true);
        for (const char* key : {"specularTexture", "specularColorTexture"}) {
            addExtensionTexture(left, model, material, "KHR_materials_specular", key,
                                "reflectance");
        }
        addExtensionTexture(left, model, material, "KHR_materials_transmission",
                            "transmissionTexture", "transmission");
        addExtensionTexture(left, model, material, "KHR_materials_anisotropy", "anisotropyTexture",
                            "anisotropy");
        addExtensionTexture(left, model, material, "KHR_materials_volume", "thicknessTexture",
                            "thickness");
    }
}

} // namespace

LeftOut leftOutOf(const tinygltf::Model& model) {
    LeftOut left;
    addAll(left, What::Animation, model.animations);
    addAll(left, What::Skin, model.skins);
    addAll(left, What::Camera, model.cameras);
    addAll(left, What::Light, model.lights);
    addMeshes(left, model);
    addExtensions(left, model);
    addMaterials(left, model);
    return left;
}

} // namespace patina
