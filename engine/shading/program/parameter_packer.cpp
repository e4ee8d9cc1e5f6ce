// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/parameter_packer.h"

#include <algorithm>
#include <array>
#include <limits>

#include "catalog/unit_direction.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

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

using Numbers = std::array<double, maxComponents>;

/// Writes the numbers of a field from the first; the others stay.
void write(Numbers& numbers, const ParameterField& field, const Values& values,
           const AccuracyLevels& levels, const PackedAround& around) {
    if (field.parameter == nullptr) {
        numbers[0] = static_cast<double>(chosenIndex(*field.choice, levels));
        return;
    }
    const Parameter& parameter = *field.parameter;
    writeNumbers(parameter, givenValue(parameter, values), numbers.data());
    if (parameter.space != Space::None) {
        const glm::dvec3 placed =
            inWorld(parameter, {numbers[0], numbers[1], numbers[2]}, around.cameraToWorld);
        std::copy_n(&placed.x, 3, numbers.begin());
    }
    takeWavelengths(parameter, around.wavelengths, numbers.data());
}

/// Limits a number to what a float holds.
float narrowed(double number) {
    constexpr double maxFloat = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(number, -maxFloat, maxFloat));
}

} // namespace

void packInto(std::span<glm::vec4> out, const ParameterLayout& layout, const Values& values,
              const AccuracyLevels& levels, const PackedAround& around) {
    std::fill_n(out.begin(), layout.floats / 4, glm::vec4(0.0f));
    Numbers numbers{};
    for (const ParameterField& field : layout.fields) {
        write(numbers, field, values, levels, around);
        for (std::size_t i = 0; i < static_cast<std::size_t>(field.components); ++i) {
            const std::size_t place = field.offset + i;
            out[place / 4][static_cast<int>(place % 4)] = narrowed(numbers[i]);
        }
    }
}

} // namespace patina
