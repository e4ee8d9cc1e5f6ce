// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/edge_case_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace patina {
namespace {

/// The next float; above 0 the smallest normal one, because devices take what is smaller as 0.
double nextFloat(double x) {
    using Limits = std::numeric_limits<float>;
    return x == 0.0
               ? static_cast<double>(Limits::min())
               : static_cast<double>(std::nextafter(static_cast<float>(x), Limits::infinity()));
}

/// Sorted by importance; what lies outside the range is left out.
std::vector<double> edgeCaseNumbers(const Parameter& parameter) {
    std::vector<double> numbers{parameter.min,
                                parameter.max,
                                0.0,
                                parameter.softMin,
                                parameter.softMax,
                                nextFloat(parameter.min),
                                nextFloat(0.0),
                                1e-25};
    numbers.insert(numbers.end(), {nextFloat(parameter.softMin), parameter.softMin + parameter.step,
                                   parameter.softMax + parameter.step});
    numbers.insert(numbers.end(), {1.0, 1e-4, 1.0 + 1e-6, 1.5, 1e3, 1e5, 1e-3, 0.05, 10.0, 100.0,
                                   1.0 - 1e-6, 0.5});
    std::vector<double> legal;
    for (const double number : numbers) {
        const auto rounded = static_cast<double>(static_cast<float>(number));
        const bool inside = rounded >= parameter.min && rounded <= parameter.max;
        if (inside && std::find(legal.begin(), legal.end(), rounded) == legal.end()) {
            legal.push_back(rounded);
        }
    }
    return legal;
}

std::vector<Value> choices(const Parameter& parameter) {
    std::vector<Value> values;
    for (const EnumValue& value : parameter.values) {
        values.emplace_back(value.id);
    }
    return values;
}

std::vector<Value> wholeNumbers(const Parameter& parameter) {
    std::vector<Value> values;
    for (const double number : edgeCaseNumbers(parameter)) {
        values.emplace_back(static_cast<int>(std::ceil(number)));
    }
    return values;
}

/// Equal components, and mixtures of the ends with what is between.
template <class Vector>
std::vector<Value> vectors(const Parameter& parameter) {
    const std::vector<double> numbers = edgeCaseNumbers(parameter);
    std::vector<Value> values;
    for (const double number : numbers) {
        values.emplace_back(Vector(number));
    }
    for (std::size_t i = 0; i + 2 < std::min<std::size_t>(numbers.size(), 8); ++i) {
        Vector mixed(numbers[i + 2]);
        mixed[0] = numbers[i];
        mixed[1] = numbers[i + 1];
        values.emplace_back(mixed);
    }
    return values;
}

std::vector<Value> scalars(const Parameter& parameter) {
    std::vector<Value> values;
    for (const double number : edgeCaseNumbers(parameter)) {
        values.emplace_back(number);
    }
    return values;
}

std::vector<Value> allHard(const Parameter& parameter) {
    switch (parameter.type) {
    case ParameterType::Bool:
        return {false, true};
    case ParameterType::Enum:
        return choices(parameter);
    case ParameterType::Int:
        return wholeNumbers(parameter);
    case ParameterType::Vec2:
        return vectors<glm::dvec2>(parameter);
    case ParameterType::Vec3:
    case ParameterType::Color:
        return vectors<glm::dvec3>(parameter);
    case ParameterType::Texture:
        return {};
    default:
        return scalars(parameter);
    }
}

} // namespace

std::vector<Value> edgeCaseValues(const Parameter& parameter) {
    std::vector<Value> values{roundedToFloat(parameter.defaultValue)};
    for (const Value& value : allHard(parameter)) {
        const Value legal = roundedToFloat(conformed(parameter, value));
        if (std::find(values.begin(), values.end(), legal) == values.end()) {
            values.push_back(legal);
        }
    }
    return values;
}

} // namespace patina
