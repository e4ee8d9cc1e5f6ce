// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_file.h"

#include "catalog/value_json.h"
#include "material/block_values.h"
#include "scene/mesh_path.h"
#include "scene/picture_accuracy_file.h"
#include "scene/scene_words.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// The number that comes back: what is read is a float.
double narrow(double value) {
    return static_cast<float>(value);
}

Json triple(const glm::dvec3& value) {
    return {narrow(value.x), narrow(value.y), narrow(value.z)};
}

Json toJson(const Object& object, const std::filesystem::path& folder) {
    Json json = object.unknown;
    json["name"] = object.name;
    json["mesh"] = meshForFile(object.mesh, folder);
    json["fitUnitBox"] = object.fitUnitBox;
    json["flipNormals"] = object.flipNormals;
    json["visible"] = object.visible;
    json["castsShadow"] = object.castsShadow;
    json["translation"] = triple(object.translation);
    json["rotation"] = triple(object.rotation);
    json["scale"] = triple(object.scale);
    json["preset"] = toJson(object.material, folder);
    return json;
}

Json toJson(const Light& light) {
    Json json = toJson(light.block);
    json["name"] = light.name;
    json["enabled"] = light.enabled;
    json["shadow"] = light.shadow ? toJson(*light.shadow) : Json();
    return json;
}

/// The picture's path is the only text in it that can be one.
Json toJson(const BlockValues& part, const std::filesystem::path& folder) {
    BlockValues moved = part;
    for (auto& [id, value] : moved.parameters) {
        if (auto* text = std::get_if<std::string>(&value)) {
            *text = meshForFile(*text, folder);
        }
    }
    return toJson(moved);
}

Json toJson(const Hemisphere& hemisphere) {
    return {{"sky", triple(hemisphere.sky)},
            {"ground", triple(hemisphere.ground)},
            {"up", triple(hemisphere.up)}};
}

Json toJson(const Camera& camera) {
    return {{"pivot", triple(camera.pivot)},
            {"yaw", narrow(camera.yaw)},
            {"pitch", narrow(camera.pitch)},
            {"distance", narrow(camera.distance)},
            {"fieldOfView", narrow(camera.fieldOfView)}};
}

template <class Words, class Meaning>
std::string wordFor(const Words& words, Meaning wanted) {
    for (const auto& [word, meaning] : words) {
        if (meaning == wanted) {
            return std::string(word);
        }
    }
    return {};
}

Json toJson(const Ground& ground) {
    return {{"mode", wordFor(groundModeWords, ground.mode)},
            {"automatic", ground.automatic},
            {"height", narrow(ground.height)},
            {"color", triple(ground.color)},
            {"opacity", narrow(ground.opacity)}};
}

} // namespace

nlohmann::json toJson(const Scene& scene, const std::filesystem::path& folder) {
    Json json = scene.unknown;
    json["format"] = sceneFormat.name;
    json["version"] = sceneFormat.version;
    json["name"] = scene.name;
    json["objects"] = Json::array();
    for (const Object& object : scene.objects) {
        json["objects"].push_back(toJson(object, folder));
    }
    json["lights"] = Json::array();
    for (const Light& light : scene.lights) {
        json["lights"].push_back(toJson(light));
    }
    json["ambient"] = triple(scene.ambient);
    json["hemisphere"].update(toJson(scene.hemisphere)); // as the camera below
    json["background"] = triple(scene.background);
    json["camera"].update(toJson(scene.camera)); // beside the keys that were not known
    json["ground"].update(toJson(scene.ground));
    json["exposure"] = narrow(scene.exposure);
    json["toneMapping"] = wordFor(toneMappingWords, scene.toneMapping);
    writePictureAccuracy(json, scene.accuracy);
    for (const std::string_view kind : partKinds(BlockOwner::Scene)) {
        const BlockValues* part = scene.part(kind);
        const std::string key(kind);
        if (part != nullptr || !json.contains(key)) { // what was not known stays
            json[key] = part != nullptr ? toJson(*part, folder) : Json();
        }
    }
    json["extras"] = scene.extras;
    return json;
}

Result<void> writeScene(const std::filesystem::path& path, const Scene& scene) {
    const std::filesystem::path folder =
        std::filesystem::absolute(path).lexically_normal().parent_path();
    return writeFileAtomically(path, writeJson(toJson(scene, folder)));
}

} // namespace patina
