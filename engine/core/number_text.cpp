// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/number_text.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace patina {

std::string shortestText(float value) {
    return fmt::format("{}", value);
}

std::string shortestFloatText(double value) {
    return shortestText(static_cast<float>(value));
}

std::string fullText(double value) {
    return fmt::format("{:.17g}", value);
}

std::optional<double> parseNumber(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) {
        return std::nullopt;
    }
    text = text.substr(first, text.find_last_not_of(" \t") - first + 1);
    if (text.front() == '+') {
        text.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

} // namespace patina
