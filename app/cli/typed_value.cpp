// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/typed_value.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/color.h"
#include "core/number_text.h"

namespace patina {
namespace {

std::string rangeText(const Parameter& parameter) {
    return fmt::format("{} .. {}", parameter.min, parameter.max);
}

std::string choicesText(const Parameter& parameter) {
    std::string out;
    for (const EnumValue& value : parameter.values) {
        out += (out.empty() ? "one of " : ", ") + value.id;
    }
    return out;
}

std::string expectedText(const Parameter& parameter) {
    switch (parameter.type) {
    case ParameterType::Enum:
        return choicesText(parameter);
    case ParameterType::Bool:
        return "true or false";
    case ParameterType::Int:
        return "a whole number, " + rangeText(parameter);
    case ParameterType::Color:
        return fmt::format("three linear numbers such as 0.8,0.2,0.1 ({} each) or #rrggbb",
                           rangeText(parameter));
    case ParameterType::Vec2:
    case ParameterType::Vec3:
        return fmt::format("{} numbers with commas, {} each", componentCount(parameter.type),
                           rangeText(parameter));
    default:
        return "a number, " + rangeText(parameter);
    }
}

/// The numbers between commas, in or without brackets; nothing unless there are `count`, all in
/// the parameter's range.
std::optional<std::vector<double>> numbersIn(const Parameter& parameter, std::string_view text,
                                             std::size_t count) {
    if (text.starts_with('[') && text.ends_with(']')) {
        text = text.substr(1, text.size() - 2);
    }
    std::vector<double> numbers;
    while (numbers.size() <= count) {
        const std::size_t comma = text.find(',');
        const std::optional<double> number = parseNumber(text.substr(0, comma));
        if (!number || *number < parameter.min || *number > parameter.max) {
            return std::nullopt;
        }
        numbers.push_back(*number);
        if (comma == std::string_view::npos) {
            break;
        }
        text.remove_prefix(comma + 1);
    }
    return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

std::optional<glm::dvec3> hexColor(std::string_view text) {
    unsigned value = 0;
    if (text.size() != 7 || text.front() != '#') {
        return std::nullopt;
    }
    const auto [end, status] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
    if (status != std::errc() || end != text.data() + 7) {
        return std::nullopt;
    }
    return srgbDecoded(glm::dvec3((value >> 16) & 255u, (value >> 8) & 255u, value & 255u) / 255.0);
}

std::optional<Value> boolIn(std::string_view text) {
    if (text == "true" || text == "yes" || text == "on" || text == "1") {
        return true;
    }
    if (text == "false" || text == "no" || text == "off" || text == "0") {
        return false;
    }
    return std::nullopt;
}

std::optional<Value> enumIn(const Parameter& parameter, std::string_view text) {
    const bool known = std::any_of(parameter.values.begin(), parameter.values.end(),
                                   [text](const EnumValue& value) { return value.id == text; });
    return known ? std::optional<Value>(std::string(text)) : std::nullopt;
}

std::optional<Value> numericIn(const Parameter& parameter, std::string_view text) {
    const auto count = static_cast<std::size_t>(componentCount(parameter.type));
    const auto numbers = numbersIn(parameter, text, count);
    if (!numbers) {
        return std::nullopt;
    }
    const std::vector<double>& n = *numbers;
    switch (parameter.type) {
    case ParameterType::Int:
        return std::trunc(n[0]) == n[0] ? std::optional<Value>(static_cast<int>(n[0]))
                                        : std::nullopt;
    case ParameterType::Vec2:
        return glm::dvec2(n[0], n[1]);
    case ParameterType::Vec3:
    case ParameterType::Color:
        return glm::dvec3(n[0], n[1], n[2]);
    default:
        return n[0];
    }
}

std::optional<Value> valueIn(const Parameter& parameter, std::string_view text) {
    switch (parameter.type) {
    case ParameterType::Bool:
        return boolIn(text);
    case ParameterType::Enum:
        return enumIn(parameter, text);
    case ParameterType::Texture:
        return std::nullopt;
    case ParameterType::Color:
        if (const auto color = hexColor(text)) {
            return *color;
        }
        return numericIn(parameter, text);
    default:
        return numericIn(parameter, text);
    }
}

} // namespace

Result<Value> valueFromText(const Parameter& parameter, std::string_view text) {
    if (const std::optional<Value> value = valueIn(parameter, text)) {
        return roundedToFloat(*value);
    }
    return failure(fmt::format("{}: \"{}\" is not a value for it", parameter.id, text),
                   expectedText(parameter));
}

} // namespace patina
