// SPDX-License-Identifier: GPL-3.0-or-later
#include "assembly_scenes.h"

#include <algorithm>
#include <array>

#include "material/block_values.h"

namespace patina::benchmarks {
namespace {

/// Lights and what lies in their way to the eye are tried with every model.
constexpr std::array surroundings{"sun", "studio", "lamps", "haze", "glow", "rim"};

/// Effects of the surface, whatever its model makes of it, are tried with a few.
constexpr std::array effects{"image", "relief", "glass", "cutout", "sky", "shade"};
constexpr std::array effectModels{"lambert", "phong", "gaussian", "oren-nayar", "cook-torrance"};

Light lightOf(const Catalog& catalog, const char* kind, const glm::dvec3& color,
              const glm::dvec3& place) {
    Light light;
    light.block = defaultBlockValues(*catalog.find("lights", kind));
    light.block.parameters["color"] = color;
    const bool isSun = light.block.parameters.contains("direction");
    light.block.parameters[isSun ? "direction" : "position"] = place;
    return light;
}

/// An image that is turned, scaled and moved.
void addImage(Material& material, const char* key) {
    TextureUse& use = material.textures[key];
    use = textureUse(key, "/image.png");
    use.scale = {3.0, 2.0};
    use.offset = {0.1, 0.2};
    use.rotation = 20.0;
}

void addLights(Scene& scene, const Catalog& catalog, const std::string& surrounding) {
    scene.lights.push_back(lightOf(catalog, "directional", {1.0, 0.95, 0.88}, {0.55, -0.8, -0.75}));
    if (surrounding == "studio") {
        scene.lights.push_back(
            lightOf(catalog, "directional", {0.4, 0.45, 0.5}, {-1.0, -0.2, -0.35}));
        scene.lights.push_back(
            lightOf(catalog, "directional", {0.7, 0.7, 0.65}, {-0.35, -0.5, 1.0}));
    } else if (surrounding == "lamps") {
        scene.lights.push_back(lightOf(catalog, "point", {0.5, 0.6, 0.7}, {2.0, 3.0, 2.0}));
        scene.lights.back().block.parameters["attenuation.quadratic"] = 0.05;
    } else if (surrounding == "shade") {
        scene.lights.back().setPart(kinds::shadows,
                                    defaultBlockValues(*catalog.find("shadows", "hard")));
    }
}

void addEffect(Scene& scene, const Catalog& catalog, const std::string& surrounding) {
    Material& material = scene.objects.front().material;
    if (surrounding == "haze") {
        scene.setPart(kinds::fog, defaultBlockValues(*catalog.find("fog", "exponential")));
    } else if (surrounding == "glow") {
        material.model.parameters["emissive.color"] = glm::dvec3(0.05, 0.1, 0.2);
    } else if (surrounding == "rim") {
        material.parts["fresnel"] = defaultBlockValues(*catalog.find("fresnel", "schlick"));
    } else if (surrounding == "image") {
        addImage(material, "diffuse.color");
    } else if (surrounding == "relief") {
        addImage(material, "normal");
    } else if (surrounding == "cutout") {
        addImage(material, "opacity");
        material.textures["opacity"].cutOut = true;
    } else if (surrounding == "glass") {
        material.opacity = 0.4;
    } else if (surrounding == "sky") {
        scene.hemisphere.sky = {0.3, 0.35, 0.4};
        scene.hemisphere.ground = {0.15, 0.1, 0.05};
    }
}

/// A model that calls the Fresnel term itself blends nothing.
bool isPossible(const Catalog& catalog, const std::string& model, const std::string& surrounding) {
    return surrounding != "rim" || catalog.find("models", model)->slot("fresnel") == nullptr;
}

} // namespace

std::vector<std::string> surroundingsOf(const Catalog& catalog, const std::string& model) {
    std::vector<std::string> names(surroundings.begin(), surroundings.end());
    if (std::ranges::find(effectModels, model) != effectModels.end()) {
        names.insert(names.end(), effects.begin(), effects.end());
    }
    std::erase_if(names,
                  [&](const std::string& name) { return !isPossible(catalog, model, name); });
    return names;
}

Scene sceneOf(const Catalog& catalog, const std::string& model, const std::string& surrounding) {
    Scene scene;
    scene.objects.emplace_back();
    scene.objects.front().material.model = defaultBlockValues(*catalog.find("models", model));
    addLights(scene, catalog, surrounding);
    addEffect(scene, catalog, surrounding);
    return scene;
}

} // namespace patina::benchmarks
