// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_materials.h"

#include <glm/common.hpp>

#include "io/material_images.h"
#include "io/material_look.h"
#include "io/mesh_parts.h"

namespace patina {
namespace {

glm::dvec3 colorOf(const std::vector<double>& numbers, double missing) {
    return numbers.size() < 3 ? glm::dvec3(missing)
                              : glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

/// Adds the image of a texture, by its number.
void addTexture(MeshMaterial& material, const char* word, int index, const tinygltf::Model& model,
                MeshFolder& folder) {
    if (index < 0 || std::size_t(index) >= model.textures.size()) {
        return;
    }
    const int source = model.textures[std::size_t(index)].source;
    if (source < 0 || std::size_t(source) >= model.images.size()) {
        return;
    }
    const std::string& uri = model.images[std::size_t(source)].uri;
    if (!uri.empty() && !uri.starts_with("data:")) {
        addImage(material, word, uri, folder);
    }
}

MeshMaterial materialFrom(const tinygltf::Material& from, const tinygltf::Model& model,
                          MeshFolder& folder) {
    MeshMaterial material;
    material.name = from.name;
    const tinygltf::PbrMetallicRoughness& look = from.pbrMetallicRoughness;
    lookMetallicRough(material, colorOf(look.baseColorFactor, 1.0), look.metallicFactor,
                      look.roughnessFactor);
    addTexture(material, material.look == "metal" ? "f0" : "diffuse", look.baseColorTexture.index,
               model, folder);
    addTexture(material, "normal", from.normalTexture.index, model, folder);
    addTexture(material, "emissive", from.emissiveTexture.index, model, folder);
    material.values["emissive"] = glm::clamp(colorOf(from.emissiveFactor, 0.0), 0.0, 1.0);
    if (from.alphaMode == "BLEND" && look.baseColorFactor.size() == 4) {
        material.values["opacity"] = glm::dvec3(glm::clamp(look.baseColorFactor[3], 0.0, 1.0));
    }
    return material;
}

} // namespace

std::vector<MeshMaterial> materialsFrom(const tinygltf::Model& model, MeshFolder& folder) {
    std::vector<MeshMaterial> materials;
    for (const tinygltf::Material& material : model.materials) {
        materials.push_back(materialFrom(material, model, folder));
    }
    nameUniquely(materials);
    return materials;
}

} // namespace patina
