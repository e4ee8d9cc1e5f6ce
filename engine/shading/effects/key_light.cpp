// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/key_light.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "core/color.h"
#include "shading/effects/light_reach.h"
#include "shading/effects/lights.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

constexpr double maxNumber = 1e30;

/// Returns a finite number from 0; `none` where no parameter has the role.
double numberOf(const Block& block, const Values& values, std::string_view role, double none) {
    const Parameter* parameter = block.withRole(role);
    const double* number =
        parameter == nullptr ? nullptr : std::get_if<double>(&givenValue(*parameter, values));
    return number == nullptr || !std::isfinite(*number) ? none
                                                        : std::clamp(*number, 0.0, maxNumber);
}

bool isInverseSquare(const Block& block, const Values& values) {
    const Parameter* parameter = block.withRole(roles::falloff);
    const auto* word =
        parameter == nullptr ? nullptr : std::get_if<std::string>(&givenValue(*parameter, values));
    return word != nullptr && *word == "inverse-square";
}

/// Computes the same as shaders/lib/illumination.glsl.
double leftAt(double distance, const Block& block, const Values& values) {
    constexpr double smallest = 1e-4;
    if (isInverseSquare(block, values)) {
        const double x = std::max(distance, numberOf(block, values, roles::nearest, smallest));
        return 1.0 / std::max(x * x, smallest * smallest);
    }
    const double linear = numberOf(block, values, roles::linear, 0.0);
    const double quadratic = numberOf(block, values, roles::quadratic, 0.0);
    const double sum =
        numberOf(block, values, roles::constant, 1.0) + distance * (linear + quadratic * distance);
    return 1.0 / std::max(sum, smallest);
}

/// Returns what range and cone leave.
double arrivingAt(const glm::dvec3& way, double distance, const LightReach& reach) {
    const bool isBeside = reach.angle > 0.0 && distance > 0.0 &&
                          glm::dot(way / distance, reach.axis) < std::cos(reach.angle);
    if (isBeside) {
        return 0.0;
    }
    const double share = reach.range > 0.0 ? std::min(distance / reach.range, 1.0) : 0.0;
    return 1.0 - share * share * share * share;
}

/// Returns the mean of the places of what is seen.
glm::dvec3 middleOf(const Scene& scene) {
    glm::dvec3 sum(0.0);
    double count = 0.0;
    for (const Object& object : scene.objects) {
        if (object.visible) {
            sum += object.translation;
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : sum;
}

} // namespace

double brightnessAt(const Light& light, const Block& block, const glm::dvec3& point) {
    const Values& values = light.block.parameters;
    const Parameter* color = block.withRole(roles::color);
    const auto* given =
        color == nullptr ? nullptr : std::get_if<glm::dvec3>(&givenValue(*color, values));
    const glm::dvec3 sent = given == nullptr ? glm::dvec3(1.0) : glm::max(*given, 0.0);
    double brightness = luminance(sent) * numberOf(block, values, roles::intensity, 1.0);
    if (block.reach) {
        const LightReach reach = reachOf(light, block);
        const glm::dvec3 way = point - reach.from;
        const double distance = glm::length(way);
        brightness *= leftAt(distance, block, values) * arrivingAt(way, distance, reach);
    }
    return std::isfinite(brightness) ? std::max(brightness, 0.0) : 0.0;
}

std::optional<std::size_t> keyLight(const Scene& scene, const Catalog& catalog) {
    const glm::dvec3 middle = middleOf(scene);
    std::optional<std::size_t> key;
    double brightest = 0.0;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = catalog.find(kinds::lights, light.block.id);
        if (block == nullptr || !canShine(light, *block)) {
            continue;
        }
        const bool isMarkedFirst = light.isKey && key && !scene.lights[*key].isKey;
        if (key && scene.lights[*key].isKey && !light.isKey) {
            continue;
        }
        const double brightness = brightnessAt(light, *block, middle);
        if (!key || isMarkedFirst || brightness > brightest) {
            key = i;
            brightest = brightness;
        }
    }
    return key;
}

} // namespace patina
