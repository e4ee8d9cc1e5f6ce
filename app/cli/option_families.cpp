// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/option_families.h"

#include <string>

#include <CLI/CLI.hpp>

namespace patina {

CLI::Option* addFamiliesOption(CLI::App& command, std::vector<const GpuFamily*>& families) {
    std::string names;
    for (const GpuFamily& family : gpuFamilies()) {
        names += (names.empty() ? "" : ", ") + family.id;
    }
    return command.add_option_function<std::string>(
        "--gpu",
        [&families](const std::string& list) {
            auto chosen = gpuFamiliesIn(list);
            if (!chosen) {
                throw CLI::ValidationError("--gpu", chosen.error().text());
            }
            families = std::move(*chosen);
        },
        "Predict costs on families of graphics cards that need not be here, by Mesa's compiler "
        "or ARM's: one or more of " +
            names);
}

} // namespace patina
