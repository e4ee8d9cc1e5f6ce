// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/turning.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "scene/turntable.h"
#include "viewport/camera_moves.h"
#include "viewport/spaces.h"

namespace patina {
namespace {

const glm::dvec3 worldRight{1.0, 0.0, 0.0};
const glm::dvec3 worldUp{0.0, 1.0, 0.0};

glm::dmat3 pull(const glm::dvec3& right, double yaw, double pitch) {
    const glm::dmat4 aboutUp = glm::rotate(glm::dmat4(1.0), glm::radians(yaw), worldUp);
    return glm::dmat3(glm::rotate(aboutUp, glm::radians(pitch), right));
}

glm::dvec3 turned(const glm::dvec3& value, Space space, const Camera& camera, double yaw,
                  double pitch) {
    if (isOfCamera(space)) {
        return pull(worldRight, yaw, pitch) * value;
    }
    const glm::dvec3 origin = isPoint(space) ? camera.pivot : glm::dvec3(0.0);
    return origin + pull(rightOf(camera), yaw, pitch) * (value - origin);
}

} // namespace

glm::dvec3 turnedRotation(const glm::dvec3& rotation, const Camera& camera, double yaw,
                          double pitch) {
    Object object;
    object.rotation = rotation;
    return anglesOf(pull(rightOf(camera), yaw, pitch) * glm::dmat3(worldMatrix(object)));
}

Values turnedLight(const Values& values, const Block& light, const Camera& camera, double yaw,
                   double pitch) {
    Values result = values;
    for (const Parameter& parameter : light.parameters) {
        const auto found = values.find(parameter.id);
        const Value& held = found == values.end() ? parameter.defaultValue : found->second;
        const auto* vector = std::get_if<glm::dvec3>(&held);
        if (vector && parameter.space != Space::None) {
            result[parameter.id] =
                roundedToFloat(turned(*vector, parameter.space, camera, yaw, pitch));
        }
    }
    return result;
}

bool canTurn(const Block& light) {
    return std::any_of(light.parameters.begin(), light.parameters.end(),
                       [](const Parameter& p) { return p.space != Space::None; });
}

int lightToTurn(const Scene& scene, const Catalog& catalog, int preferred) {
    const auto suits = [&](const Light& light) {
        const Block* block = catalog.find(kinds::lights, light.block.id);
        return light.enabled && block && canTurn(*block);
    };
    const auto count = static_cast<int>(scene.lights.size());
    if (preferred >= 0 && preferred < count &&
        suits(scene.lights[static_cast<std::size_t>(preferred)])) {
        return preferred;
    }
    const auto first = std::find_if(scene.lights.begin(), scene.lights.end(), suits);
    return first == scene.lights.end() ? -1 : static_cast<int>(first - scene.lights.begin());
}

} // namespace patina
