// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/turntable.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "scene/environment.h"

namespace patina {
namespace {

const glm::dvec3 upwards{0.0, 1.0, 0.0};

glm::dmat3 turnMatrix(const glm::dvec3& axis, double degrees) {
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis));
}

void turnObjects(Scene& scene, double degrees) {
    glm::dvec3 middle(0.0);
    for (const Object& object : scene.objects) {
        middle += object.translation / double(scene.objects.size());
    }
    for (Object& object : scene.objects) {
        object.translation = middle + turnedAbout(object.translation - middle, upwards, degrees);
        object.rotation = rotationTurnedAbout(object.rotation, upwards, degrees);
    }
}

/// Turns the light's points and directions of world space, points about `pivot`. Returns false
/// where it has none, as a light that moves with the camera.
bool turnLight(Light& light, const Block& block, const glm::dvec3& pivot, double degrees) {
    bool isTurned = false;
    for (const Parameter& parameter : block.parameters) {
        const bool isPoint = parameter.space == Space::WorldPoint;
        if (!isPoint && parameter.space != Space::WorldDirection) {
            continue;
        }
        const auto held = light.block.parameters.find(parameter.id);
        const Value& value =
            held == light.block.parameters.end() ? parameter.defaultValue : held->second;
        if (const auto* vector = std::get_if<glm::dvec3>(&value)) {
            const glm::dvec3 origin = isPoint ? pivot : glm::dvec3(0.0);
            light.block.parameters[parameter.id] =
                conformed(parameter, origin + turnedAbout(*vector - origin, upwards, degrees));
            isTurned = true;
        }
    }
    return isTurned;
}

bool turnLights(Scene& scene, const Catalog& catalog, double degrees) {
    bool isTurned = false;
    for (Light& light : scene.lights) {
        const Block* block = catalog.find(kinds::lights, light.block.id);
        isTurned |= block != nullptr && turnLight(light, *block, scene.camera.pivot, degrees);
    }
    return isTurned;
}

bool turnEnvironment(Scene& scene, const Catalog& catalog, double degrees) {
    BlockValues* held = scene.part(kinds::environment);
    const Block* block = blockOf(scene.parts, kinds::environment, catalog);
    const Parameter* parameter = block == nullptr ? nullptr : block->withRole(roles::rotate);
    if (held == nullptr || parameter == nullptr) {
        return false;
    }
    const double now = environmentNumber(*held, *block, roles::rotate);
    const double range = parameter->max - parameter->min;
    double turned = now + degrees;
    turned = range >= 360.0 ? parameter->min + std::fmod(turned - parameter->min, 360.0) : turned;
    turned += turned < parameter->min ? 360.0 : 0.0;
    held->parameters[parameter->id] = conformed(*parameter, turned);
    return true;
}

} // namespace

glm::dvec3 turnedAbout(const glm::dvec3& vector, const glm::dvec3& axis, double degrees) {
    return turnMatrix(axis, degrees) * vector;
}

glm::dvec3 anglesOf(const glm::dmat3& m) {
    const double sinY = std::clamp(-m[0][2], -1.0, 1.0);
    const double cosY = std::hypot(m[1][2], m[2][2]);
    // Looking along the axis only x - z or x + z is defined: z is then taken as 0.
    const bool locked = cosY < 1e-9;
    const double x = locked ? std::atan2(-m[2][1], m[1][1]) : std::atan2(m[1][2], m[2][2]);
    const double z = locked ? 0.0 : std::atan2(m[0][1], m[0][0]);
    return glm::degrees(glm::dvec3(x, std::atan2(sinY, cosY), z));
}

glm::dvec3 rotationTurnedAbout(const glm::dvec3& rotation, const glm::dvec3& axis, double degrees) {
    Object object;
    object.rotation = rotation;
    return anglesOf(turnMatrix(axis, degrees) * glm::dmat3(worldMatrix(object)));
}

Result<Scene> onTurntable(const Scene& scene, const Catalog& catalog, TurntableOf what,
                          double degrees) {
    Scene turned = scene;
    switch (what) {
    case TurntableOf::Object:
        turnObjects(turned, degrees);
        return turned;
    case TurntableOf::Light:
        if (!turnLights(turned, catalog, degrees)) {
            return failure("no light of the scene can be turned",
                           "a light that stands in the scene, not at the camera");
        }
        return turned;
    case TurntableOf::Environment:
        if (!turnEnvironment(turned, catalog, degrees)) {
            return failure("the scene has no environment that can be turned", "--environment");
        }
        return turned;
    }
    return turned;
}

std::filesystem::path seriesFile(const std::filesystem::path& file, int number) {
    return file.parent_path() /
           fmt::format("{}.{:04}{}", file.stem().string(), number, file.extension().string());
}

} // namespace patina
