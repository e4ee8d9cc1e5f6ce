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

#include "catalog/wavelengths.h"
#include "material/material.h"
#include "scene/ground.h"
#include "scene/picture_accuracy.h"

namespace patina {

/// Is a mesh in the scene with its own material.
struct Object {
    std::string name;
    std::string mesh = "builtin:sphere"; ///< is "builtin:<name>", or a path with forward slashes
    std::string part; ///< names the material of the mesh file whose triangles it has; empty: all
    bool fitUnitBox = false; ///< scales and centres the mesh into [-1, 1]^3 before the transform
    bool flipNormals = false;
    bool visible = true;
    bool castsShadow = true;     ///< applies to lights with shadows
    glm::dvec3 translation{0.0}; ///< metres
    glm::dvec3 rotation{0.0};    ///< degrees about x, then y, then z
    glm::dvec3 scale{1.0};
    glm::dvec3 shear{0.0}; ///< slant along x per y, along x per z, and along y per z, once scaled
    Material material;
    std::string group; ///< is selected as a whole; empty: it is in none
    nlohmann::json unknown = nlohmann::json::object();

    friend bool operator==(const Object&, const Object&) = default;
};

/// Is a light of the scene: a light block of the catalogue with its values and parts.
struct Light {
    std::string name;
    bool enabled = true;
    BlockValues block;
    BlockParts parts{};         ///< have a shadow where objects cast one in it
    bool isKey = false;         ///< marks it as a light that drawings take (DrawingLights)
    bool isMutedBySolo = false; ///< says that it is off only while another light is alone

    const BlockValues* part(std::string_view kind) const { return partOf(parts, kind); }
    BlockValues* part(std::string_view kind) { return partOf(parts, kind); }
    void setPart(std::string_view kind, std::optional<BlockValues> values) {
        patina::setPart(parts, kind, std::move(values));
    }

    friend bool operator==(const Light&, const Light&) = default;
};

/// Is a perspective camera that orbits a pivot. World space is right-handed with +y up.
struct Camera {
    glm::dvec3 pivot{0.0};
    double yaw = 30.0;         ///< degrees about +y; it looks along -z at 0
    double pitch = 20.0;       ///< degrees above the horizon, -90 .. 90
    double distance = 4.0;     ///< metres from the pivot, > 0
    double fieldOfView = 35.0; ///< degrees, vertical, 1 .. 170
    double nearPlane = 0.0;    ///< metres before which nothing is drawn; 0: it cuts nothing
    double farPlane = 0.0;     ///< metres behind which nothing is drawn; 0: it cuts nothing

    friend bool operator==(const Camera&, const Camera&) = default;
};

/// Is ambient light from two half spaces, as under a uniform sky over a uniform ground.
struct Hemisphere {
    glm::dvec3 sky{0.0};          ///< linear light on a surface that faces up
    glm::dvec3 ground{0.0};       ///< linear light on a surface that faces down
    glm::dvec3 up{0.0, 1.0, 0.0}; ///< has any length; of length 0 it counts as +y

    friend bool operator==(const Hemisphere&, const Hemisphere&) = default;
};

/// Tells which of a scene's lights a drawing takes, which is a material whose model wants the key
/// light.
enum class DrawingLights { Key, All };

/// Holds everything that is drawn. It is a value: undo keeps copies of it.
struct Scene {
    std::string name;
    std::vector<Object> objects;
    std::vector<Light> lights;
    BlockParts parts;                ///< may name a picture, by its full path
    std::vector<BlockValues> passes; ///< work over the finished picture, one after the other
    glm::dvec3 ambient{0.0};         ///< linear light from everywhere
    Hemisphere hemisphere;           ///< adds to `ambient`
    bool occlusion = false;       ///< lets objects hide these and the environment from themselves
    glm::dvec3 background{0.18f}; ///< linear light; a float, as files hold it
    Ground ground;
    Camera camera;
    std::map<int, Camera> bookmarks; ///< are views by the digit 1 .. 9 of their key
    double exposure = 0.0;           ///< EV, powers of two
    DrawingLights drawings = DrawingLights::Key;
    glm::dvec3 wavelengths = srgbWavelengths; ///< nm, that stand for red, green and blue
    PictureAccuracy accuracy;                 ///< is the picture's, whatever the materials
    nlohmann::json extras = nlohmann::json::object();
    nlohmann::json unknown = nlohmann::json::object();

    const BlockValues* part(std::string_view kind) const { return partOf(parts, kind); }
    BlockValues* part(std::string_view kind) { return partOf(parts, kind); }
    void setPart(std::string_view kind, std::optional<BlockValues> values) {
        patina::setPart(parts, kind, std::move(values));
    }

    friend bool operator==(const Scene&, const Scene&) = default;
};

/// Returns the matrix from object space to world space: translation * rotation * shear * scale.
glm::dmat4 worldMatrix(const Object& object);

glm::dvec3 eye(const Camera& camera);
glm::dmat4 viewMatrix(const Camera& camera);

} // namespace patina
