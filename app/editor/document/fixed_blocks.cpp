// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/fixed_blocks.h"

#include <functional>
#include <map>

#include "docks/picture_accuracy_form.h"
#include "scene/scene_limits.h"

namespace patina {

namespace {

/// How one member of `Owner` is read and written as a parameter value.
template <class Owner>
struct Access {
    std::function<Value(const Owner&)> read;
    std::function<void(Owner&, const Value&)> write;
};

template <class Owner>
using AccessTable = std::map<std::string, Access<Owner>, std::less<>>;

/// A member whose type is one of the alternatives of Value.
template <class Owner, class Member>
Access<Owner> member(Member Owner::*field) {
    return {[field](const Owner& owner) { return Value(owner.*field); },
            [field](Owner& owner, const Value& value) {
                if (const Member* held = std::get_if<Member>(&value)) {
                    owner.*field = *held;
                }
            }};
}

const char* const noToneMapping = "none";
const char* const neutralToneMapping = "khronos-neutral";

Access<Scene> toneMappingAccess() {
    return {[](const Scene& scene) {
                const bool none = scene.toneMapping == ToneMapping::None;
                return Value(std::string(none ? noToneMapping : neutralToneMapping));
            },
            [](Scene& scene, const Value& value) {
                if (const auto* id = std::get_if<std::string>(&value)) {
                    scene.toneMapping =
                        *id == noToneMapping ? ToneMapping::None : ToneMapping::KhronosNeutral;
                }
            }};
}

Access<Scene> hemisphereAccess(glm::dvec3 Hemisphere::*field) {
    return {[field](const Scene& scene) { return Value(scene.hemisphere.*field); },
            [field](Scene& scene, const Value& value) {
                if (const auto* held = std::get_if<glm::dvec3>(&value)) {
                    scene.hemisphere.*field = *held;
                }
            }};
}

const char* const noGround = "off";
const char* const shadowGround = "shadows";
const char* const planeGround = "plane";

Access<Scene> groundModeAccess() {
    return {[](const Scene& scene) {
                const GroundMode mode = scene.ground.mode;
                return Value(std::string(mode == GroundMode::Off       ? noGround
                                         : mode == GroundMode::Shadows ? shadowGround
                                                                       : planeGround));
            },
            [](Scene& scene, const Value& value) {
                if (const auto* id = std::get_if<std::string>(&value)) {
                    scene.ground.mode = *id == noGround       ? GroundMode::Off
                                        : *id == shadowGround ? GroundMode::Shadows
                                                              : GroundMode::Plane;
                }
            }};
}

/// A member of the scene's ground.
template <class Member>
Access<Scene> groundMember(Member Ground::*field) {
    const Access<Ground> inner = member(field);
    return {[inner](const Scene& scene) { return inner.read(scene.ground); },
            [inner](Scene& scene, const Value& value) { inner.write(scene.ground, value); }};
}

const AccessTable<Scene>& sceneTable() {
    static const AccessTable<Scene> table{{"ambient", member(&Scene::ambient)},
                                          {"ambient.sky", hemisphereAccess(&Hemisphere::sky)},
                                          {"ambient.ground",
                                           hemisphereAccess(&Hemisphere::ground)},
                                          {"ambient.up", hemisphereAccess(&Hemisphere::up)},
                                          {"background", member(&Scene::background)},
                                          {"exposure", member(&Scene::exposure)},
                                          {"toneMapping", toneMappingAccess()},
                                          {"ground.mode", groundModeAccess()},
                                          {"ground.automatic", groundMember(&Ground::automatic)},
                                          {"ground.height", groundMember(&Ground::height)},
                                          {"ground.color", groundMember(&Ground::color)},
                                          {"ground.opacity", groundMember(&Ground::opacity)}};
    return table;
}

/// The same numbers as a scene file may hold.
Access<Object> scaleAccess() {
    const Access<Object> inner = member(&Object::scale);
    return {inner.read, [inner](Object& object, const Value& value) {
                inner.write(object, value);
                object.scale = usableScale(object.scale);
            }};
}

const AccessTable<Object>& objectTable() {
    static const AccessTable<Object> table{
        {"visible", member(&Object::visible)},       {"castsShadow", member(&Object::castsShadow)},
        {"translation", member(&Object::translation)},
        {"rotation", member(&Object::rotation)},     {"scale", scaleAccess()},
        {"fitUnitBox", member(&Object::fitUnitBox)}, {"flipNormals", member(&Object::flipNormals)}};
    return table;
}

const AccessTable<Material>& materialTable() {
    static const AccessTable<Material> table{{"opacity", member(&Material::opacity)}};
    return table;
}

template <class Owner>
std::optional<Value> read(const AccessTable<Owner>& table, const Owner& owner,
                          std::string_view id) {
    const auto found = table.find(id);
    return found == table.end() ? std::nullopt : std::optional<Value>(found->second.read(owner));
}

template <class Owner>
void write(const AccessTable<Owner>& table, Owner& owner, std::string_view id, const Value& value) {
    if (const auto found = table.find(id); found != table.end()) {
        found->second.write(owner, value);
    }
}

Parameter described(ParameterType type, std::string id, std::string label, std::string doc,
                    Value defaultValue) {
    Parameter parameter;
    parameter.type = type;
    parameter.id = std::move(id);
    parameter.label = std::move(label);
    parameter.doc = std::move(doc);
    parameter.defaultValue = std::move(defaultValue);
    return parameter;
}

Parameter ranged(Parameter parameter, glm::dvec2 hard, glm::dvec2 soft, double step,
                 std::string unit = {}) {
    parameter.min = hard.x;
    parameter.max = hard.y;
    parameter.softMin = soft.x;
    parameter.softMax = soft.y;
    parameter.step = step;
    parameter.unit = std::move(unit);
    return parameter;
}

/// Light or a colour to look at: the picker starts with what a screen can show.
Parameter bright(std::string id, std::string label, std::string doc, const glm::dvec3& color) {
    return ranged(described(ParameterType::Color, std::move(id), std::move(label), std::move(doc),
                            color),
                  {0.0, brightest}, {0.0, 1.0}, 0.01);
}

Parameter toneMappingParameter() {
    Parameter parameter =
        described(ParameterType::Enum, "toneMapping", "Tone mapping",
                  "How brightness beyond what a screen can show is brought back into its range.",
                  std::string(neutralToneMapping));
    parameter.values = {{noToneMapping, "None", "Values above 1 are cut off. Best for measuring."},
                        {neutralToneMapping, "Khronos neutral",
                         "Keeps base colours as they are and rolls off highlights only."}};
    return parameter;
}

std::vector<Parameter> groundParameters() {
    Parameter mode = described(ParameterType::Enum, "ground.mode", "Ground",
                               "A level plane under the objects. Shadows fall on it where a light "
                               "has them.",
                               std::string(noGround));
    mode.values = {{noGround, "Off", "No ground."},
                   {shadowGround, "Shadows only", "Only the shadows on it are seen: they darken "
                                                  "the background."},
                   {planeGround, "Plane", "A matt plane that the lights shine on."}};
    Parameter automatic = described(ParameterType::Bool, "ground.automatic", "Under the objects",
                                    "Lay the ground at the lowest point of the objects.", true);
    automatic.enabledWhen = "ground.mode != off";
    Parameter height = ranged(described(ParameterType::Float, "ground.height", "Height",
                                        "How high the ground lies.", 0.0),
                              {-farthest, farthest}, {-5.0, 5.0}, 0.01, "m");
    height.enabledWhen = "ground.mode != off and not ground.automatic";
    Parameter color = described(ParameterType::Color, "ground.color", "Ground colour",
                                "The share of the light that comes back from the plane.",
                                Ground().color);
    color.enabledWhen = "ground.mode == plane";
    Parameter opacity = described(ParameterType::Float, "ground.opacity", "Ground opacity",
                                  "How much of the ground, or of its shadows, is there.", 1.0);
    opacity.enabledWhen = "ground.mode != off";
    return {mode, automatic, height, color, opacity};
}

} // namespace

Block sceneBlock() {
    Block block;
    block.id = "scene";
    block.label = "Scene";
    block.parameters = {
        bright("ambient", "Ambient light", "Light that comes from everywhere and casts no shape.",
               Scene().ambient),
        bright("ambient.sky", "Sky light", "Ambient light on what faces up.", Hemisphere().sky),
        bright("ambient.ground", "Ground light",
               "Ambient light on what faces down, as the ground throws it back.",
               Hemisphere().ground),
        ranged(described(ParameterType::Vec3, "ambient.up", "Up",
                         "Where the sky light comes from. Its length does not matter.",
                         Hemisphere().up),
               {-farthest, farthest}, {-1.0, 1.0}, 0.01),
        bright("background", "Background", "The colour behind the objects. It lights nothing.",
               Scene().background),
        ranged(described(ParameterType::Float, "exposure", "Exposure",
                         "Brightness of the whole picture: each step up doubles it.", 0.0),
               {-maxStops, maxStops}, {-4.0, 4.0}, 0.1, "EV"),
        toneMappingParameter()};
    for (Parameter& parameter : groundParameters()) {
        block.parameters.push_back(std::move(parameter));
    }
    for (Parameter& parameter : pictureAccuracyParameters()) {
        block.parameters.push_back(std::move(parameter));
    }
    return block;
}

Block objectBlock() {
    Block block;
    block.id = "object";
    block.label = "Object";
    block.parameters = {
        described(ParameterType::Bool, "visible", "Visible", "Draw this object.", true),
        described(ParameterType::Bool, "castsShadow", "Casts shadow",
                  "Keep light from others, where a light has shadows. Objects that let more than "
                  "half of the light through never do; an opacity map leaves its holes in the "
                  "shadow.",
                  true),
        ranged(described(ParameterType::Vec3, "translation", "Position", "Where the object stands.",
                         glm::dvec3(0.0)),
               {-farthest, farthest}, {-5.0, 5.0}, 0.01, "m"),
        ranged(described(ParameterType::Vec3, "rotation", "Rotation",
                         "Turned about the x axis first, then y, then z.", glm::dvec3(0.0)),
               {-farthest, farthest}, {-180.0, 180.0}, 1.0, "deg"),
        ranged(described(ParameterType::Vec3, "scale", "Scale",
                         "Size along each axis. Negative numbers mirror.", glm::dvec3(1.0)),
               {-largestScale, largestScale}, {0.0, 4.0}, 0.01),
        described(ParameterType::Bool, "fitUnitBox", "Fit to unit box",
                  "Centre the mesh and make its longest side two metres (-1 to 1) before anything "
                  "else.",
                  false),
        described(ParameterType::Bool, "flipNormals", "Flip normals",
                  "For meshes whose surfaces point inwards and look black.", false)};
    return block;
}

Block materialBlock() {
    Block block;
    block.id = "material";
    block.label = "Material";
    Parameter opacity = described(ParameterType::Float, "opacity", "Opacity",
                                  "1 is solid, 0 lets everything behind shine through.", 1.0);
    opacity.textureChannels = {"rgb", "r", "g", "b", "a"};
    Parameter normal = described(ParameterType::Texture, "normal", "Normal map",
                                 "An image that bends the surface: red to the right, green up.",
                                 std::string());
    normal.textureChannels = {"rgb"};
    Parameter height = described(ParameterType::Texture, "height", "Height map",
                                 "An image that raises the surface: white is high.", std::string());
    height.textureChannels = {"r", "g", "b", "a"};
    block.parameters = {std::move(opacity), std::move(normal), std::move(height)};
    return block;
}

namespace {

void addChoice(Block& block, const AccuracyChoice& choice) {
    if (choice.values.empty() || block.parameter(choice.id) != nullptr) {
        return;
    }
    Parameter parameter = described(ParameterType::Enum, choice.id, choice.label, choice.doc,
                                    choice.values.front().id);
    parameter.values = choice.values;
    parameter.compiled = Compiled::Yes;
    block.parameters.push_back(std::move(parameter));
}

} // namespace

Block accuracyBlock(std::span<const Block* const> blocks) {
    Block block;
    block.id = "accuracy";
    block.label = "Accuracy";
    for (const Block* used : blocks) {
        for (const AccuracyChoice& choice : used->accuracy) {
            addChoice(block, choice);
        }
    }
    return block;
}

std::optional<Value> sceneValue(const Scene& scene, std::string_view parameterId) {
    const std::optional<Value> level = pictureLevel(scene, parameterId);
    return level ? level : read(sceneTable(), scene, parameterId);
}

std::optional<Value> objectValue(const Object& object, std::string_view parameterId) {
    return read(objectTable(), object, parameterId);
}

std::optional<Value> materialValue(const Material& material, std::string_view parameterId) {
    return read(materialTable(), material, parameterId);
}

void storeSceneValue(Scene& scene, std::string_view parameterId, const Value& value) {
    write(sceneTable(), scene, parameterId, value);
    storePictureLevel(scene, parameterId, value);
}

void storeObjectValue(Object& object, std::string_view parameterId, const Value& value) {
    write(objectTable(), object, parameterId, value);
}

void storeMaterialValue(Material& material, std::string_view parameterId, const Value& value) {
    write(materialTable(), material, parameterId, value);
}

} // namespace patina
