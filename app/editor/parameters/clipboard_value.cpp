// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/clipboard_value.h"

#include <algorithm>
#include <cmath>

#include "catalog/value_json.h"
#include "core/color.h"
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

/// Returns the number of an expression as people type it ("2 * 0.25", "30 deg"), kept in the
/// parameter's range; nothing when the text is none.
std::optional<Value> pastedNumber(const Parameter& parameter, std::string_view text) {
    const std::optional<double> number = evaluateNumber(text, parameter.unit);
    if (!number) {
        return std::nullopt;
    }
    const double inside = std::clamp(*number, parameter.min, parameter.max);
    if (std::holds_alternative<int>(parameter.defaultValue)) {
        return static_cast<int>(std::lround(inside));
    }
    return inside;
}

std::optional<Value> interpreted(const Parameter& parameter, std::string_view text) {
    if (auto value = infoOf(parameter.type).fromText(parameter, text)) {
        return value;
    }
    if (infoOf(parameter.type).isColor) { // hex without its "#"
        const auto color = colorOfHex(trimmed(text, "# \t"));
        return color ? std::optional<Value>(*color) : std::nullopt;
    }
    const bool isNumber = std::holds_alternative<int>(parameter.defaultValue) ||
                          std::holds_alternative<double>(parameter.defaultValue);
    return isNumber ? pastedNumber(parameter, text) : std::nullopt;
}

} // namespace

std::string copiedText(const Value& value) {
    return textOf(value);
}

std::optional<Value> pastedValue(const Parameter& parameter, std::string_view text) {
    std::optional<Value> value = interpreted(parameter, trimmed(text, " \t\r\n"));
    return value && isFinite(*value) ? std::optional<Value>(conformed(parameter, *value))
                                     : std::nullopt;
}

} // namespace patina
