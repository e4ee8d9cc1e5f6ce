// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/role_checks.h"

#include <fmt/format.h>

namespace patina {

namespace {

/// Empty when the parameter may be a share that passes.
std::string transparencyMistake(const Parameter& parameter) {
    if (parameter.type != ParameterType::Float || parameter.min < 0.0 || parameter.max > 1.0) {
        return "only a float from 0 to 1 can be a share that passes";
    }
    return parameter.textureChannels.empty()
               ? std::string()
               : "what passes by a value that takes an image is not known";
}

bool canTellWidth(const Parameter& parameter) {
    return parameter.type == ParameterType::Float || parameter.type == ParameterType::Angle;
}

} // namespace

Errors roleMistakes(const Descriptor& descriptor) {
    const std::vector<Parameter>& parameters = descriptor.block.parameters;
    Errors errors;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto add = [&](const char* key, std::string problem) {
            errors.push_back(descriptor.document.error(fmt::format("/parameters/{}/{}", i, key),
                                                       std::move(problem), "no such key"));
        };
        const Parameter& parameter = parameters[i];
        const std::string mistake = transparencyMistake(parameter);
        if (parameter.transparency && !mistake.empty()) {
            add("transparency", mistake);
        }
        if (parameter.highlight != HighlightWidth::None && !canTellWidth(parameter)) {
            add("highlight", "only a number can say how wide a highlight is");
        }
    }
    return errors;
}

} // namespace patina
