// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/transparency.h"

#include <algorithm>

namespace patina {
namespace {

/// Limits what a user's own block may ask for.
constexpr int maxLayers = 64;

int wholeNumber(const Value& value) {
    const int* number = std::get_if<int>(&value);
    return number == nullptr ? 1 : *number;
}

} // namespace

const Parameter* layersParameter(const Block& transparency) {
    return transparency.withRole(roles::layers);
}

int layersOf(const BlockValues& transparency, const Block& block) {
    const Parameter* parameter = layersParameter(block);
    if (parameter == nullptr) {
        return 0;
    }
    const auto given = transparency.parameters.find(parameter->id);
    const bool usable =
        given != transparency.parameters.end() && std::holds_alternative<int>(given->second);
    return std::clamp(wholeNumber(usable ? given->second : parameter->defaultValue), 1, maxLayers);
}

} // namespace patina
