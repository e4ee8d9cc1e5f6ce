// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/transparency_checks.h"

#include <fmt/format.h>

namespace patina {

Errors transparencyMistakes(const Descriptor& descriptor) {
    const std::vector<Parameter>& parameters = descriptor.block.parameters;
    Errors errors;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Parameter& parameter = parameters[i];
        if (!parameter.transparency) {
            continue;
        }
        const auto add = [&](const char* problem) {
            errors.push_back(descriptor.document.error(
                fmt::format("/parameters/{}/transparency", i), problem, "no such key"));
        };
        if (parameter.type != ParameterType::Float || parameter.min < 0.0 || parameter.max > 1.0) {
            add("only a float from 0 to 1 can be a share that passes");
        } else if (!parameter.textureChannels.empty()) {
            add("what passes by a value that takes an image is not known");
        }
    }
    return errors;
}

} // namespace patina
