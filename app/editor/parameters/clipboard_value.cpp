// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/clipboard_value.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/color.h"
#include "core/number_text.h"
#include "parameters/number_expression.h"

namespace patina {

namespace {

std::string_view trimmed(std::string_view text, std::string_view what) {
    const std::size_t first = text.find_first_not_of(what);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(what) - first + 1);
}

/// "[1, 2, 3]", "1, 2, 3" or "1 2 3". A comma separates here; decimals have a point.
std::optional<std::vector<double>> numbersOf(std::string_view text) {
    std::string separated(trimmed(text, "[]() \t\r\n"));
    std::replace(separated.begin(), separated.end(), ',', ' ');
    std::vector<double> numbers;
    for (std::string_view rest = separated; !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
        const std::optional<double> number = parseNumber(rest.substr(0, end));
        if (!number) {
            return std::nullopt;
        }
        numbers.push_back(*number);
        rest = trimmed(rest.substr(end), " \t");
    }
    return numbers;
}

std::optional<Value> pastedTriple(std::string_view text) {
    const std::optional<std::vector<double>> numbers = numbersOf(text);
    if (!numbers || numbers->size() != 3) {
        return std::nullopt;
    }
    return glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::optional<Value> pastedPair(std::string_view text) {
    const std::optional<std::vector<double>> numbers = numbersOf(text);
    if (!numbers || numbers->size() != 2) {
        return std::nullopt;
    }
    return glm::dvec2((*numbers)[0], (*numbers)[1]);
}

std::optional<Value> pastedColor(std::string_view text) {
    if (const std::optional<glm::dvec3> color = colorOfHex(text)) {
        return *color;
    }
    return pastedTriple(text);
}

std::optional<Value> pastedTruth(std::string_view text) {
    const bool truth = text == "true" || text == "1" || text == "on" || text == "yes";
    const bool lie = text == "false" || text == "0" || text == "off" || text == "no";
    return truth || lie ? std::optional<Value>(truth) : std::nullopt;
}

std::optional<Value> pastedChoice(const Parameter& parameter, std::string_view text) {
    for (const EnumValue& value : parameter.values) {
        if (value.id == text || value.label == text) {
            return value.id;
        }
    }
    return std::nullopt;
}

std::optional<Value> pastedNumber(const Parameter& parameter, std::string_view text) {
    const std::optional<double> number = evaluateNumber(text, parameter.unit);
    if (!number) {
        return std::nullopt;
    }
    const double inside = std::clamp(*number, parameter.min, parameter.max);
    if (parameter.type == ParameterType::Int) {
        return static_cast<int>(std::lround(inside));
    }
    return inside;
}

std::optional<Value> interpreted(const Parameter& parameter, std::string_view text) {
    switch (parameter.type) {
    case ParameterType::Bool:
        return pastedTruth(text);
    case ParameterType::Color:
        return pastedColor(text);
    case ParameterType::Vec2:
        return pastedPair(text);
    case ParameterType::Vec3:
        return pastedTriple(text);
    case ParameterType::Enum:
        return pastedChoice(parameter, text);
    case ParameterType::Texture:
        return std::nullopt;
    default:
        return pastedNumber(parameter, text);
    }
}

struct Writer {
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(int number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return shortestFloatText(number); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const glm::dvec2& v) const {
        return fmt::format("[{}, {}]", shortestFloatText(v.x), shortestFloatText(v.y));
    }
    std::string operator()(const glm::dvec3& v) const {
        return fmt::format("[{}, {}, {}]", shortestFloatText(v.x), shortestFloatText(v.y),
                           shortestFloatText(v.z));
    }
};

} // namespace

std::string copiedText(const Value& value) {
    return std::visit(Writer(), value);
}

std::optional<Value> pastedValue(const Parameter& parameter, std::string_view text) {
    std::optional<Value> value = interpreted(parameter, trimmed(text, " \t\r\n"));
    return value && isFinite(*value) ? std::optional<Value>(conformed(parameter, *value))
                                     : std::nullopt;
}

std::string hexOf(const glm::dvec3& linear) {
    const glm::dvec3 encoded = srgbEncoded(linear) * 255.0;
    return fmt::format("#{:02x}{:02x}{:02x}", std::lround(encoded.x), std::lround(encoded.y),
                       std::lround(encoded.z));
}

std::optional<glm::dvec3> colorOfHex(std::string_view text) {
    std::string digits(trimmed(text, "# \t"));
    if (digits.size() == 3) { // "#8cf" is short for "#88ccff"
        digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    }
    unsigned bits = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, status] = std::from_chars(digits.data(), end, bits, 16);
    if (digits.size() != 6 || status != std::errc() || stop != end) {
        return std::nullopt;
    }
    const glm::dvec3 encoded((bits >> 16) & 0xffu, (bits >> 8) & 0xffu, bits & 0xffu);
    return srgbDecoded(encoded / 255.0);
}

} // namespace patina
