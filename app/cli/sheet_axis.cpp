// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sheet_axis.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/number_text.h"
#include "sheet/sheet_file.h"

namespace patina {
namespace {

constexpr const char* expectedAxis =
    "id=from:to:steps, id=value,value, or models, accuracy, lights or environments, alone or with "
    "a list";

std::vector<std::string> cutAt(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::size_t at = 0;
    while (at <= text.size()) {
        const std::size_t end = std::min(text.find(separator, at), text.size());
        parts.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return parts;
}

/// Reads three numbers with colons between them; returns nothing for anything else.
std::optional<SheetRange> rangeFrom(const std::string& text) {
    const std::vector<std::string> parts = cutAt(text, ':');
    if (parts.size() != 3) {
        return std::nullopt;
    }
    const auto from = parseNumber(parts[0]);
    const auto to = parseNumber(parts[1]);
    const auto steps = parseNumber(parts[2]);
    const bool isWhole = steps && std::floor(*steps) == *steps && std::abs(*steps) < 1e6;
    return from && to && isWhole ? std::optional(SheetRange{*from, *to, static_cast<int>(*steps)})
                                 : std::nullopt;
}

} // namespace

Result<SheetAxis> axisFromText(const std::string& text) {
    const std::size_t equals = text.find('=');
    SheetAxis axis;
    axis.value = text.substr(0, equals);
    for (const auto& [kind, word] : axisWords) {
        if (kind != AxisKind::Value && axis.value == word) {
            axis.kind = kind;
            axis.value.clear();
        }
    }
    if (axis.kind == AxisKind::Value && axis.value.empty()) {
        return failure(fmt::format("\"{}\" is no axis", text), expectedAxis);
    }
    if (equals == std::string::npos) {
        return axis;
    }
    const std::string list = text.substr(equals + 1);
    if (list.empty()) {
        return failure(fmt::format("\"{}\" has no steps", text), expectedAxis);
    }
    axis.range = axis.kind == AxisKind::Value ? rangeFrom(list) : std::nullopt;
    if (!axis.range) {
        axis.entries = cutAt(list, list.find(';') == std::string::npos ? ',' : ';');
    }
    return axis;
}

} // namespace patina
