// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/environment.h"

#include <algorithm>
#include <cmath>

namespace patina {
namespace {

constexpr int minDirections = 4; ///< is the number that one round draws
constexpr int maxUnasked = 256;

const std::string* textOf(const BlockValues& values, const Parameter& parameter) {
    const auto found = values.parameters.find(parameter.id);
    const Value& value = found == values.parameters.end() ? parameter.defaultValue : found->second;
    return std::get_if<std::string>(&value);
}

} // namespace

const Parameter* pictureParameter(const Block& environment) {
    const auto found = std::find_if(environment.parameters.begin(), environment.parameters.end(),
                                    [](const Parameter& p) { return infoOf(p.type).isFile; });
    return found == environment.parameters.end() ? nullptr : &*found;
}

std::string_view pictureFile(const BlockValues& environment, const Block& block) {
    const Parameter* parameter = pictureParameter(block);
    const std::string* file = parameter == nullptr ? nullptr : textOf(environment, *parameter);
    return file == nullptr ? std::string_view() : *file;
}

Backdrop backdropOf(const BlockValues& environment, const Block& block) {
    const Parameter* parameter = block.withRole(roles::background);
    const std::string* word = parameter == nullptr ? nullptr : textOf(environment, *parameter);
    if (word == nullptr) {
        return Backdrop::Sharp;
    }
    return *word == "hidden"    ? Backdrop::Hidden
           : *word == "blurred" ? Backdrop::Blurred
                                : Backdrop::Sharp;
}

const Parameter* directionsParameter(const Block& environment) {
    return environment.withRole(roles::directions);
}

int directionsOf(const BlockValues& environment, const Block& block) {
    const Parameter* parameter = directionsParameter(block);
    if (parameter == nullptr) {
        return usualDirections;
    }
    const auto given = environment.parameters.find(parameter->id);
    const bool isGiven = given != environment.parameters.end();
    const Value value = conformed(*parameter, isGiven ? given->second : parameter->defaultValue);
    return std::max(std::get<int>(value), minDirections);
}

int unaskedDirections(const Scene& scene, const Catalog& catalog) {
    const Block* block = blockOf(scene.parts, kinds::environment, catalog);
    return block == nullptr
               ? maxUnasked
               : std::min(directionsOf(*scene.part(kinds::environment), *block), maxUnasked);
}

double environmentNumber(const BlockValues& environment, const Block& block,
                         std::string_view role) {
    const Parameter* parameter = block.withRole(role);
    if (parameter == nullptr) {
        return 0.0;
    }
    const auto found = environment.parameters.find(parameter->id);
    const auto* given =
        found == environment.parameters.end() ? nullptr : std::get_if<double>(&found->second);
    const auto* usual = std::get_if<double>(&parameter->defaultValue);
    const double number = given != nullptr && std::isfinite(*given) ? *given
                          : usual != nullptr                        ? *usual
                                                                    : 0.0;
    return std::clamp(number, parameter->min, parameter->max);
}

} // namespace patina
