// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_file.h"

#include "catalog/settings.h"
#include "core/atomic_file.h"
#include "material/block_values.h"
#include "scene/mesh_path.h"
#include "scene/picture_accuracy_file.h"
#include "scene/scene_format.h"
#include "scene/scene_settings.h"

namespace patina {
namespace {

using Json = nlohmann::json;

/// Adds the settings that settingsBlock() has for a word to an object.
template <class Owner>
void writeSettingsOf(const Owner& owner, std::string_view word, Json& json) {
    writeSettings(json, *settingsBlock(word),
                  [&owner](std::string_view id) { return settingOf(owner, id); });
}

Json toJson(const Object& object, const std::filesystem::path& folder) {
    Json json = object.unknown;
    json["name"] = object.name;
    json["mesh"] = meshForFile(object.mesh, folder);
    if (!object.part.empty()) {
        json["part"] = object.part;
    }
    if (!object.group.empty()) {
        json["group"] = object.group;
    }
    writeSettingsOf(object, settings::object, json);
    if (object.shear == glm::dvec3(0.0)) {
        json.erase("shear");
    }
    json["preset"] = toJson(object.material, folder);
    return json;
}

/// Returns the JSON of a part. Every text is treated as a path, since only a picture's can be
/// absolute.
Json toJson(const BlockValues& part, const std::filesystem::path& folder) {
    BlockValues moved = part;
    for (auto& [id, value] : moved.parameters) {
        if (auto* text = std::get_if<std::string>(&value)) {
            *text = meshForFile(*text, folder);
        }
    }
    return toJson(moved);
}

void writeParts(Json& json, const BlockParts& parts, BlockOwner owner,
                const std::filesystem::path& folder) {
    for (const std::string_view kind : partKinds(owner)) {
        const BlockValues* part = partOf(parts, kind);
        const std::string key(findKind(kind)->singular);
        if (part != nullptr || !json.contains(key)) { // what was not known stays
            json[key] = part != nullptr ? toJson(*part, folder) : Json();
        }
    }
}

Json toJson(const Light& light, const std::filesystem::path& folder) {
    Json json = toJson(light.block);
    json["name"] = light.name;
    if (light.isMutedBySolo) {
        json["mutedBySolo"] = true;
    }
    writeSettingsOf(light, settings::light, json);
    writeParts(json, light.parts, BlockOwner::Light, folder);
    return json;
}

Json emptySceneJson() {
    return {{"format", sceneFormat.name}, {"version", sceneFormat.version}};
}

template <class Element>
Json jsonOfAll(std::span<const Element> elements, const std::filesystem::path& folder) {
    Json json = Json::array();
    for (const Element& element : elements) {
        json.push_back(toJson(element, folder));
    }
    return json;
}

} // namespace

nlohmann::json sceneJsonOf(std::span<const Object> objects) {
    Json json = emptySceneJson();
    json["objects"] = jsonOfAll(objects, {});
    return json;
}

nlohmann::json sceneJsonOf(std::span<const Light> lights) {
    Json json = emptySceneJson();
    json["lights"] = jsonOfAll(lights, {});
    return json;
}

nlohmann::json toJson(const Scene& scene, const std::filesystem::path& folder) {
    Json json = scene.unknown;
    json["format"] = sceneFormat.name;
    json["version"] = sceneFormat.version;
    json["name"] = scene.name;
    json["objects"] = jsonOfAll(std::span<const Object>(scene.objects), folder);
    json["lights"] = jsonOfAll(std::span<const Light>(scene.lights), folder);
    writeSettingsOf(scene, settings::scene, json);
    writeSettingsOf(scene.camera, settings::camera, json[std::string(settings::camera)]);
    for (const auto& [digit, camera] : scene.bookmarks) {
        writeSettingsOf(camera, settings::camera, json["bookmarks"][std::to_string(digit)]);
    }
    writePictureAccuracy(json, scene.accuracy);
    writeParts(json, scene.parts, BlockOwner::Scene, folder);
    if (!scene.passes.empty()) {
        json["passes"] = Json::array();
        for (const BlockValues& pass : scene.passes) {
            json["passes"].push_back(toJson(pass, folder));
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
