// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/assimp_materials.h"

#include <algorithm>

#include <assimp/material.h>
#include <glm/common.hpp>

#include "core/color.h"
#include "io/material_images.h"
#include "io/material_look.h"
#include "io/mesh_parts.h"

namespace patina {
namespace {

constexpr double darkest = 1e-4; ///< is a colour that no picture shows

/// Reads one material of a scene.
class MaterialReader {
  public:
    MaterialReader(const aiMaterial& from, MeshFolder& folder, LeftOut& left)
        : from_(from), folder_(folder), left_(left) {}

    MeshMaterial read() {
        material_.name = from_.GetName().C_Str();
        float metallic = 0.0f;
        const bool isPhysical = from_.Get(AI_MATKEY_METALLIC_FACTOR, metallic) == aiReturn_SUCCESS;
        if (isPhysical) {
            readPhysical(metallic);
        } else {
            readClassical();
        }
        float opacity = 1.0f;
        if (from_.Get(AI_MATKEY_OPACITY, opacity) == aiReturn_SUCCESS && opacity < 1.0f) {
            material_.values["opacity"] = glm::dvec3(std::clamp(opacity, 0.0f, 1.0f));
        }
        addFirst("opacity", {aiTextureType_OPACITY});
        addFirst("normal", {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA});
        addFirst("height", {aiTextureType_HEIGHT});
        addFirst("emissive", {aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR});
        return std::move(material_);
    }

  private:
    void readPhysical(double metallic) {
        aiColor4D base(1.0f, 1.0f, 1.0f, 1.0f);
        from_.Get(AI_MATKEY_BASE_COLOR, base);
        float roughness = 1.0f;
        from_.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness);
        lookMetallicRough(material_, {base.r, base.g, base.b}, metallic, roughness);
        addFirst(material_.isMetal() ? "f0" : "diffuse",
                 {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
    }

    void readClassical() {
        const auto diffuse = color("$clr.diffuse");
        const auto specular = color("$clr.specular");
        float shininess = 0.0f;
        from_.Get(AI_MATKEY_SHININESS, shininess);
        addFirst("diffuse", {aiTextureType_DIFFUSE});
        const bool isShiny = specular && shininess > 0.0f &&
                             std::max({specular->x, specular->y, specular->z}) > darkest;
        if (diffuse || !material_.images.empty() || isShiny) {
            material_.look = isShiny ? shinyLook() : "matte";
            material_.values["diffuse"] = diffuse.value_or(glm::dvec3(1.0));
        }
        if (isShiny) {
            material_.values["specular"] = *specular;
            material_.values["shininess"] = glm::dvec3(shininess);
            addFirst("specular", {aiTextureType_SPECULAR});
        }
        if (const auto glow = color("$clr.emissive")) {
            material_.values["emissive"] = *glow;
        }
    }

    /// Returns whose highlight it is: of n.h in Blinn's sense, as the MTL format defines it, or of
    /// the mirrored ray where the file says so in another format.
    const char* shinyLook() const {
        int mode = 0;
        from_.Get(AI_MATKEY_SHADING_MODEL, mode);
        const std::string format = folder_.file().extension().string();
        const bool isObj = format == ".obj" || format == ".OBJ";
        return mode == aiShadingMode_Phong && !isObj ? "phong" : "blinn-phong";
    }

    std::optional<glm::dvec3> color(const char* key) const {
        aiColor3D value;
        if (from_.Get(key, 0, 0, value) != aiReturn_SUCCESS) {
            return std::nullopt;
        }
        return srgbDecoded(glm::dvec3(value.r, value.g, value.b));
    }

    void addFirst(const char* word, std::initializer_list<aiTextureType> types) {
        std::string missing;
        for (const aiTextureType type : types) {
            aiString path;
            if (from_.GetTexture(type, 0, &path) != aiReturn_SUCCESS || path.length == 0 ||
                path.C_Str()[0] == '*') { // is inside the file
                continue;
            }
            if (addImage(material_, word, path.C_Str(), folder_)) {
                return;
            }
            missing = fileNameIn(path.C_Str());
        }
        if (!missing.empty()) {
            left_.add(LeftOut::What::MissingImage, missing);
        }
    }

    const aiMaterial& from_;
    MeshFolder& folder_;
    LeftOut& left_;
    MeshMaterial material_;
};

} // namespace

std::vector<MeshMaterial> materialsFrom(const aiScene& scene, MeshFolder& folder, LeftOut& left) {
    std::vector<MeshMaterial> materials;
    for (unsigned int i = 0; i < scene.mNumMaterials; ++i) {
        materials.push_back(MaterialReader(*scene.mMaterials[i], folder, left).read());
    }
    nameUniquely(materials);
    return materials;
}

} // namespace patina
