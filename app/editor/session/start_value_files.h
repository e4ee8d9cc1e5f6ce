// SPDX-License-Identifier: GPL-3.0-or-later
// The user's own start values of models, a file each in $XDG_CONFIG_HOME/patina/start-values.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace patina {

/// Returns where they lie.
std::filesystem::path startValueFolder();

/// What was read: model's id -> "parameters" as in a preset, and what was wrong.
struct StartValueReading {
    std::map<std::string, nlohmann::json, std::less<>> values;
    Errors errors;
};

StartValueReading readStartValues(const std::filesystem::path& folder);

/// Writes those of a model; null removes them.
Result<void> writeStartValues(const std::filesystem::path& folder, const std::string& model,
                              const nlohmann::json& parameters);

} // namespace patina
