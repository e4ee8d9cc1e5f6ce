// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/highlight_width.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

/// Returns the function that widens what a parameter says; null where that is no highlight's width.
const char* wideningOf(const Parameter& parameter) {
    switch (parameter.highlight) {
    case HighlightWidth::Slope:
        return "widenedSlope";
    case HighlightWidth::Exponent:
        return "widenedExponent";
    case HighlightWidth::Angle:
        return "widenedAngle";
    case HighlightWidth::None:
        break;
    }
    return nullptr;
}

} // namespace

bool hasHighlightWidth(const Block& block) {
    return std::ranges::any_of(block.parameters, [](const Parameter& parameter) {
        return wideningOf(parameter) != nullptr;
    });
}

std::string widenedSource(const Block& block, const std::string& variable) {
    std::string source;
    for (const Parameter& parameter : block.parameters) {
        if (const char* widening = wideningOf(parameter)) {
            const std::string field = variable + '.' + fieldName(parameter.id);
            source += fmt::format("    {0} = {1}({0}, spread);\n", field, widening);
        }
    }
    return source;
}

} // namespace patina
