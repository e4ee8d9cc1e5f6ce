// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/mesh_look.h"

#include <fmt/format.h>

#include "catalog/json_text.h"
#include "core/number_text.h"
#include "material/block_assignment.h"
#include "material/material_assignment.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// Is how a material of one look becomes a preset.
struct Recipe {
    std::string model;
    std::vector<std::string> assignments;      ///< are made before those of the material's values
    std::map<std::string, std::string> values; ///< maps a word of MeshMaterial to a parameter's id
};

Result<Recipe> recipeFor(const std::string& look) {
    const auto file = dataFolder() / "presets" / "mesh-looks.json";
    const auto document = readJson(file);
    if (!document) {
        return tl::unexpected(document.error());
    }
    const Json& all = document->value;
    if (!all.is_object() || !all.contains(look)) {
        return failure(fmt::format("there is no recipe for the look \"{}\"", look));
    }
    try {
        const Json& found = all.at(look);
        return Recipe{found.at("model").get<std::string>(),
                      found.value("set", std::vector<std::string>()),
                      found.at("values").get<std::map<std::string, std::string>>()};
    } catch (const Json::exception& problem) {
        return failure(fmt::format("{}: the recipe for \"{}\" is damaged: {}", file.string(), look,
                                   problem.what()));
    }
}

std::string assignmentOf(const std::string& id, const glm::dvec3& value, const Parameter& to) {
    return to.type == ParameterType::Color ? fmt::format("{}={},{},{}", id, fullText(value.x),
                                                         fullText(value.y), fullText(value.z))
                                           : fmt::format("{}={}", id, fullText(value.x));
}

/// Lays the images on the surface and on the parameters that have the values of the same words. An
/// image on a colour is multiplied with it, as all formats do, unless nothing would be left.
void layImages(Material& material, const MeshMaterial& from, const Recipe& recipe) {
    for (const auto& [word, file] : from.images) {
        const auto parameter = recipe.values.find(word);
        const std::string key = parameter == recipe.values.end() ? word : parameter->second;
        if (parameter == recipe.values.end() && textureRole(key) == TextureRole::Input) {
            continue;
        }
        TextureUse use = textureUse(key, file);
        const auto value = from.values.find(word);
        const bool isVisible = value != from.values.end() && value->second != glm::dvec3(0.0);
        if (textureRole(key) == TextureRole::Input && isVisible) {
            use.mode = TextureMode::Multiply;
        }
        material.textures[key] = use;
    }
}

} // namespace

Result<Material> materialOf(const MeshMaterial& from, const Catalog& catalog) {
    const auto recipe = recipeFor(from.look);
    if (!recipe) {
        return tl::unexpected(recipe.error());
    }
    const auto model = knownBlock(catalog, kinds::models, recipe->model);
    if (!model) {
        return tl::unexpected(model.error());
    }
    Material material = defaultMaterial(**model);
    material.name = from.name;
    Result<void> done;
    for (const std::string& assignment : recipe->assignments) {
        done = done.and_then([&] { return assignInMaterial(material, assignment, catalog); });
    }
    for (const auto& [word, id] : recipe->values) {
        const auto value = from.values.find(word);
        const Parameter* parameter = parameterIn(material, id, catalog);
        if (value != from.values.end() && parameter != nullptr) {
            done = done.and_then([&, &id = id] {
                return assignInMaterial(material, assignmentOf(id, value->second, *parameter),
                                        catalog);
            });
        }
    }
    if (!done) {
        return tl::unexpected(done.error());
    }
    if (const auto opacity = from.values.find("opacity"); opacity != from.values.end()) {
        material.opacity = opacity->second.x;
    }
    layImages(material, from, *recipe);
    return material;
}

} // namespace patina
