// SPDX-License-Identifier: GPL-3.0-or-later
#include "lobe/picked_incidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "viewport/light_pose.h"

namespace patina {
namespace {

constexpr double degreesPerRadian = 180.0 / std::numbers::pi;

/// Returns the unit direction from a point to a light; towards the eye where it has no place.
glm::dvec3 towards(const Light& light, const Block& block, const Camera& camera,
                   const glm::dvec3& point) {
    const auto pose = lightPose(light.block.parameters, block, camera);
    if (!pose) {
        return glm::normalize(eye(camera) - point);
    }
    return pose->hasPoint() || !pose->direction ? glm::normalize(pose->point - point)
                                                : -*pose->direction;
}

/// Returns any unit vector across a unit one.
glm::dvec3 anyAcross(const glm::dvec3& n) {
    const glm::dvec3 axis =
        std::abs(n.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(glm::cross(n, axis));
}

} // namespace

Incoming PickedIncidence::incoming() const {
    return {std::acos(std::clamp(light.z, 0.0, 1.0)), std::atan2(light.y, light.x)};
}

double PickedIncidence::viewerDegrees() const {
    const double angle = std::acos(std::clamp(viewer.z, 0.0, 1.0)) * degreesPerRadian;
    return light.x * viewer.x + light.y * viewer.y > 0.0 ? -angle : angle;
}

double PickedIncidence::outOfPlane() const {
    const double azimuth = incoming().azimuth;
    const double across = viewer.y * std::cos(azimuth) - viewer.x * std::sin(azimuth);
    return std::asin(std::clamp(std::abs(across), 0.0, 1.0)) * degreesPerRadian;
}

std::optional<PickedIncidence> incidenceAt(const Hit& hit, const Scene& scene,
                                           const Catalog& catalog, const Camera& camera,
                                           std::size_t light) {
    const Block* block = light < scene.lights.size()
                             ? catalog.find(kinds::lights, scene.lights[light].block.id)
                             : nullptr;
    if (block == nullptr) {
        return std::nullopt;
    }
    const glm::dvec3& n = hit.normal;
    const glm::dvec3 t = glm::length(hit.tangent) > 0.5 ? hit.tangent : anyAcross(n);
    const glm::dvec3 b = glm::cross(n, t);
    const auto inFrame = [&](const glm::dvec3& d) {
        return glm::dvec3(glm::dot(d, t), glm::dot(d, b), glm::dot(d, n));
    };
    PickedIncidence picked;
    picked.light = inFrame(towards(scene.lights[light], *block, camera, hit.point));
    picked.viewer = inFrame(glm::normalize(eye(camera) - hit.point));
    return picked.light.z > 0.0 && picked.viewer.z > 0.0 ? std::optional(picked) : std::nullopt;
}

} // namespace patina
