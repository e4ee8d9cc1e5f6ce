// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_settings.h"

#include <array>
#include <string>
#include <utility>

#include "material/member_access.h"
#include "scene/scene_limits.h"

namespace patina {
namespace {

/// Pairs the values of an enumeration with their words in descriptors and files.
template <class T, std::size_t N>
using SettingWords = std::array<std::pair<std::string_view, T>, N>;

constexpr SettingWords<DrawingLights, 2> drawingWords{
    {{"key", DrawingLights::Key}, {"all", DrawingLights::All}}};

constexpr SettingWords<GroundMode, 3> groundModeWords{
    {{"off", GroundMode::Off}, {"shadows", GroundMode::Shadows}, {"plane", GroundMode::Plane}}};

template <class T, std::size_t N>
std::string settingWord(const SettingWords<T, N>& words, T wanted) {
    for (const auto& [word, meaning] : words) {
        if (meaning == wanted) {
            return std::string(word);
        }
    }
    return {};
}

/// Stores what a word means; `into` is unchanged where the value is no word of them.
template <class T, std::size_t N>
void storeWord(const SettingWords<T, N>& words, const Value& value, T& into) {
    const auto* given = std::get_if<std::string>(&value);
    for (const auto& [word, meaning] : words) {
        into = given != nullptr && *given == word ? meaning : into;
    }
}

MemberAccess<Scene> groundMode() {
    return {
        [](const Scene& scene) { return Value(settingWord(groundModeWords, scene.ground.mode)); },
        [](Scene& scene, const Value& value) {
            storeWord(groundModeWords, value, scene.ground.mode);
        }};
}

MemberAccess<Scene> drawings() {
    return {
        [](const Scene& scene) { return Value(settingWord(drawingWords, scene.drawings)); },
        [](Scene& scene, const Value& value) { storeWord(drawingWords, value, scene.drawings); }};
}

const MemberTable<Scene>& sceneMembers() {
    static const MemberTable<Scene> members{
        {"ambient", member(&Scene::ambient)},
        {"hemisphere.sky", member(&Scene::hemisphere, &Hemisphere::sky)},
        {"hemisphere.ground", member(&Scene::hemisphere, &Hemisphere::ground)},
        {"hemisphere.up", member(&Scene::hemisphere, &Hemisphere::up)},
        {"occlusion", member(&Scene::occlusion)},
        {"background", member(&Scene::background)},
        {"exposure", member(&Scene::exposure)},
        {"drawings", drawings()},
        {"wavelengths", member(&Scene::wavelengths)},
        {"ground.mode", groundMode()},
        {"ground.automatic", member(&Scene::ground, &Ground::automatic)},
        {"ground.height", member(&Scene::ground, &Ground::height)},
        {"ground.color", member(&Scene::ground, &Ground::color)},
        {"ground.opacity", member(&Scene::ground, &Ground::opacity)}};
    return members;
}

const MemberTable<Camera>& cameraMembers() {
    static const MemberTable<Camera> members{{"pivot", member(&Camera::pivot)},
                                             {"yaw", member(&Camera::yaw)},
                                             {"pitch", member(&Camera::pitch)},
                                             {"distance", member(&Camera::distance)},
                                             {"fieldOfView", member(&Camera::fieldOfView)},
                                             {"near", member(&Camera::nearPlane)},
                                             {"far", member(&Camera::farPlane)}};
    return members;
}

/// Reaches an object's scale and brings every factor into range, so that none flattens it.
MemberAccess<Object> scale() {
    const MemberAccess<Object> plain = member(&Object::scale);
    return {plain.read, [plain](Object& object, const Value& value) {
                plain.write(object, value);
                object.scale = usableScale(object.scale);
            }};
}

const MemberTable<Object>& objectMembers() {
    static const MemberTable<Object> members{{"visible", member(&Object::visible)},
                                             {"castsShadow", member(&Object::castsShadow)},
                                             {"translation", member(&Object::translation)},
                                             {"rotation", member(&Object::rotation)},
                                             {"scale", scale()},
                                             {"shear", member(&Object::shear)},
                                             {"fitUnitBox", member(&Object::fitUnitBox)},
                                             {"flipNormals", member(&Object::flipNormals)}};
    return members;
}

const MemberTable<Light>& lightMembers() {
    static const MemberTable<Light> members{{"enabled", member(&Light::enabled)},
                                            {"key", member(&Light::isKey)}};
    return members;
}

} // namespace

std::optional<Value> settingOf(const Scene& scene, std::string_view id) {
    return readMember(sceneMembers(), scene, id);
}

std::optional<Value> settingOf(const Camera& camera, std::string_view id) {
    return readMember(cameraMembers(), camera, id);
}

std::optional<Value> settingOf(const Object& object, std::string_view id) {
    return readMember(objectMembers(), object, id);
}

std::optional<Value> settingOf(const Light& light, std::string_view id) {
    return readMember(lightMembers(), light, id);
}

void storeSetting(Scene& scene, std::string_view id, const Value& value) {
    writeMember(sceneMembers(), scene, id, value);
}

void storeSetting(Camera& camera, std::string_view id, const Value& value) {
    writeMember(cameraMembers(), camera, id, value);
}

void storeSetting(Object& object, std::string_view id, const Value& value) {
    writeMember(objectMembers(), object, id, value);
}

void storeSetting(Light& light, std::string_view id, const Value& value) {
    writeMember(lightMembers(), light, id, value);
}

} // namespace patina
