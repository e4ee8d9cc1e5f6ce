// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/parameter_packer.h"

#include <algorithm>
#include <limits>

#include <glm/trigonometric.hpp>

#include "catalog/unit_direction.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

/// In the hard range, and never beyond what a float holds.
double limited(const Parameter& parameter, double value) {
    constexpr double most = std::numeric_limits<float>::max();
    return std::clamp(std::clamp(value, parameter.min, parameter.max), -most, most);
}

glm::dvec3 inWorld(const Parameter& parameter, const glm::dvec3& value,
                   const glm::dmat4& cameraToWorld) {
    switch (parameter.space) {
    case Space::CameraPoint:
        return glm::dvec3(cameraToWorld * glm::dvec4(value, 1.0));
    case Space::CameraDirection:
        return glm::dvec3(cameraToWorld * glm::dvec4(unitDirection(value), 0.0));
    case Space::WorldDirection:
        return unitDirection(value);
    default:
        return value;
    }
}

/// The components of a value that is not an enum's.
glm::dvec3 components(const Parameter& parameter, const Value& value) {
    if (const auto* truth = std::get_if<bool>(&value)) {
        return glm::dvec3(*truth ? 1.0 : 0.0);
    }
    if (const auto* whole = std::get_if<int>(&value)) {
        return glm::dvec3(limited(parameter, *whole));
    }
    if (const auto* number = std::get_if<double>(&value)) {
        const double inRange = limited(parameter, *number);
        return glm::dvec3(parameter.type == ParameterType::Angle ? glm::radians(inRange) : inRange);
    }
    if (const auto* pair = std::get_if<glm::dvec2>(&value)) {
        return {limited(parameter, pair->x), limited(parameter, pair->y), 0.0};
    }
    if (const auto* triple = std::get_if<glm::dvec3>(&value)) {
        return {limited(parameter, triple->x), limited(parameter, triple->y),
                limited(parameter, triple->z)};
    }
    return glm::dvec3(0.0);
}

glm::dvec3 componentsOf(const ParameterField& field, const Values& values,
                        const AccuracyLevels& levels, const glm::dmat4& cameraToWorld) {
    if (field.parameter == nullptr) {
        return glm::dvec3(static_cast<double>(chosenIndex(*field.choice, levels)));
    }
    const Parameter& parameter = *field.parameter;
    if (parameter.type == ParameterType::Enum) {
        return glm::dvec3(static_cast<double>(chosenIndex(parameter, values)));
    }
    const Value& given = givenValue(parameter, values);
    const Value& value = isFinite(given) ? given : parameter.defaultValue;
    return inWorld(parameter, components(parameter, value), cameraToWorld);
}

} // namespace

void packInto(std::span<glm::vec4> out, const ParameterLayout& layout, const Values& values,
              const AccuracyLevels& levels, const glm::dmat4& cameraToWorld) {
    std::fill_n(out.begin(), layout.floats / 4, glm::vec4(0.0f));
    for (const ParameterField& field : layout.fields) {
        const glm::dvec3 source = componentsOf(field, values, levels, cameraToWorld);
        for (int i = 0; i < field.components; ++i) {
            const std::size_t place = field.offset + static_cast<std::size_t>(i);
            out[place / 4][static_cast<int>(place % 4)] = static_cast<float>(source[i]);
        }
    }
}

} // namespace patina
