// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "material/material.h"
#include "scene/ground.h"
#include "scene/picture_accuracy.h"

namespace patina {

/// A mesh in the scene with its own material.
struct Object {
    std::string name;
    std::string mesh = "builtin:sphere"; ///< "builtin:<name>", or a path with forward slashes
    bool fitUnitBox = false; ///< scale and centre the mesh into a unit box before the transform
    bool flipNormals = false;
    bool visible = true;
    bool castsShadow = true;     ///< in the light of lights with shadows
    glm::dvec3 translation{0.0}; ///< metres
    glm::dvec3 rotation{0.0};    ///< degrees about x, then y, then z
    glm::dvec3 scale{1.0};
    Material material;
    std::string group; ///< objects of one group are selected together; empty: it is in none
    nlohmann::json unknown = nlohmann::json::object();

    friend bool operator==(const Object&, const Object&) = default;
};

/// Holds a light of some kind in the catalogue.
struct Light {
    std::string name;
    bool enabled = true;
    BlockValues block;
    BlockParts parts{};         ///< without a shadow objects cast none in it
    bool isKey = false;         ///< marked as the light that drawings take
    bool isMutedBySolo = false; ///< off only as long as another light is to be seen alone

    const BlockValues* part(std::string_view kind) const { return partOf(parts, kind); }
    BlockValues* part(std::string_view kind) { return partOf(parts, kind); }
    void setPart(std::string_view kind, std::optional<BlockValues> values) {
        patina::setPart(parts, kind, std::move(values));
    }

    friend bool operator==(const Light&, const Light&) = default;
};

/// Represents a perspective camera that orbits a pivot. World space is right-handed with +y up.
struct Camera {
    glm::dvec3 pivot{0.0};
    double yaw = 30.0;         ///< degrees about +y; 0 looks along -z
    double pitch = 20.0;       ///< degrees above the horizon, -90 .. 90
    double distance = 4.0;     ///< metres from the pivot, > 0
    double fieldOfView = 35.0; ///< vertical, degrees, 1 .. 170
    double nearPlane = 0.0;    ///< metres before which nothing is drawn; 0: it cuts nothing
    double farPlane = 0.0;     ///< metres behind which nothing is drawn; 0: it cuts nothing

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Ambient light that differs above and below: what a point on the ground under an even sky gets.
struct Hemisphere {
    glm::dvec3 sky{0.0};          ///< linear colour of the light on a surface that faces up
    glm::dvec3 ground{0.0};       ///< on one that faces down
    glm::dvec3 up{0.0, 1.0, 0.0}; ///< of any length; without one it counts as +y

    friend bool operator==(const Hemisphere&, const Hemisphere&) = default;
};

/// Tells which of a scene's lights a drawing takes: a material whose model wants the key light.
enum class DrawingLights { Key, All };

/// Everything that is drawn. A value: copying it is how undo works.
struct Scene {
    std::string name;
    std::vector<Object> objects;
    std::vector<Light> lights;
    BlockParts parts;             ///< the picture of one is a path that scene files resolve
    glm::dvec3 ambient{0.0};      ///< linear colour of the light from everywhere
    Hemisphere hemisphere;        ///< beside it
    bool occlusion = false;       ///< objects hide these and the environment from themselves
    glm::dvec3 background{0.18f}; ///< linear; a float, as files hold it
    Ground ground;
    Camera camera;
    std::map<int, Camera> bookmarks; ///< views to come back to, by the digit 1 .. 9 of their key
    double exposure = 0.0;           ///< EV, powers of two
    DrawingLights drawings = DrawingLights::Key;
    PictureAccuracy accuracy; ///< of the picture, whatever the materials
    nlohmann::json extras = nlohmann::json::object();
    nlohmann::json unknown = nlohmann::json::object();

    const BlockValues* part(std::string_view kind) const { return partOf(parts, kind); }
    BlockValues* part(std::string_view kind) { return partOf(parts, kind); }
    void setPart(std::string_view kind, std::optional<BlockValues> values) {
        patina::setPart(parts, kind, std::move(values));
    }

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// Leads from object space -> world space: translation * rotation * scale.
glm::dmat4 worldMatrix(const Object& object);

glm::dvec3 eye(const Camera& camera);
glm::dmat4 viewMatrix(const Camera& camera);

} // namespace patina
