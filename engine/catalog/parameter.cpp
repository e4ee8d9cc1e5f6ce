// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/parameter.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace patina {
namespace {

int clampedInt(const Parameter& parameter, int value) {
    return static_cast<int>(
        std::clamp<double>(value, std::ceil(parameter.min), std::floor(parameter.max)));
}

/// Into the range; a number that is the same float as an end of it, as 0.01 read back from a float
/// is, stays as it is.
double clampedNumber(const Parameter& parameter, double x) {
    const double near = std::clamp(x, parameter.min, parameter.max);
    const bool sameFloat = static_cast<float>(near) == static_cast<float>(x);
    return sameFloat && near != 0.0 ? x : near; // nothing beyond 0, which has its own sign
}

Value clamped(const Parameter& parameter, const Value& value) {
    const auto component = [&parameter](double x) { return clampedNumber(parameter, x); };
    if (const auto* number = std::get_if<double>(&value)) {
        return component(*number);
    }
    if (const auto* whole = std::get_if<int>(&value)) {
        return clampedInt(parameter, *whole);
    }
    if (const auto* two = std::get_if<glm::dvec2>(&value)) {
        return glm::dvec2(component(two->x), component(two->y));
    }
    if (const auto* three = std::get_if<glm::dvec3>(&value)) {
        return glm::dvec3(component(three->x), component(three->y), component(three->z));
    }
    return value;
}

bool isChoice(const Parameter& parameter, const Value& value) {
    const auto* id = std::get_if<std::string>(&value);
    return id != nullptr && std::any_of(parameter.values.begin(), parameter.values.end(),
                                        [id](const EnumValue& known) { return known.id == *id; });
}

} // namespace

std::size_t indexOf(const std::vector<EnumValue>& values, std::string_view id) {
    const auto found = std::find_if(values.begin(), values.end(),
                                    [id](const EnumValue& value) { return value.id == id; });
    return found == values.end() ? 0 : static_cast<std::size_t>(found - values.begin());
}

bool hasRange(ParameterType type) {
    return type != ParameterType::Bool && type != ParameterType::Enum &&
           type != ParameterType::Texture;
}

int componentCount(ParameterType type) {
    switch (type) {
    case ParameterType::Color:
    case ParameterType::Vec3:
        return 3;
    case ParameterType::Vec2:
        return 2;
    case ParameterType::Texture:
        return 0;
    default:
        return 1;
    }
}

std::vector<std::string> componentNames(const Parameter& parameter) {
    if (parameter.type != ParameterType::Vec2 && parameter.type != ParameterType::Vec3) {
        return {};
    }
    std::vector<std::string> names{"x", "y", "z"};
    names.resize(static_cast<std::size_t>(componentCount(parameter.type)));
    return parameter.components.size() == names.size() ? parameter.components : names;
}

Value conformed(const Parameter& parameter, const Value& value) {
    if (value.index() != parameter.defaultValue.index() || !isFinite(value)) {
        return parameter.defaultValue;
    }
    if (parameter.type == ParameterType::Enum && !isChoice(parameter, value)) {
        return parameter.defaultValue;
    }
    return clamped(parameter, value);
}

std::string fieldName(std::string_view parameterId) {
    std::string out;
    bool capital = false;
    for (const char c : parameterId) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) {
            capital = !out.empty();
            continue;
        }
        out += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        capital = false;
    }
    return out;
}

} // namespace patina
