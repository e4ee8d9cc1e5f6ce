// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_file.h"

#include "catalog/value_json.h"
#include "material/block_values.h"
#include "scene/mesh_path.h"
#include "scene/scene_words.h"

namespace patina {
namespace {

using Json = nlohmann::json;

Json triple(const glm::dvec3& value) {
    return {value.x, value.y, value.z};
}

Json toJson(const Object& object, const std::filesystem::path& folder) {
    Json json = object.unknown;
    json["name"] = object.name;
    json["mesh"] = meshForFile(object.mesh, folder);
    json["fitUnitBox"] = object.fitUnitBox;
    json["flipNormals"] = object.flipNormals;
    json["visible"] = object.visible;
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
    return json;
}

Json toJson(const Camera& camera) {
    return {{"pivot", triple(camera.pivot)},
            {"yaw", camera.yaw},
            {"pitch", camera.pitch},
            {"distance", camera.distance},
            {"fieldOfView", camera.fieldOfView}};
}

std::string wordFor(ToneMapping toneMapping) {
    for (const auto& [word, meaning] : toneMappingWords) {
        if (meaning == toneMapping) {
            return std::string(word);
        }
    }
    return {};
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
    json["fog"] = scene.fog ? toJson(*scene.fog) : Json();
    json["ambient"] = triple(scene.ambient);
    json["background"] = triple(scene.background);
    json["camera"].update(toJson(scene.camera)); // beside the keys that were not known
    json["exposure"] = scene.exposure;
    json["toneMapping"] = wordFor(scene.toneMapping);
    json["environment"] = scene.environment;
    json["extras"] = scene.extras;
    return json;
}

Result<void> writeScene(const std::filesystem::path& path, const Scene& scene) {
    const std::filesystem::path folder =
        std::filesystem::absolute(path).lexically_normal().parent_path();
    return writeFileAtomically(path, writeJson(toJson(scene, folder)));
}

} // namespace patina
