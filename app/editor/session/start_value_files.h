// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes the user's own start values of models, a file each in
// $XDG_CONFIG_HOME/patina/start-values.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace patina {

/// Returns the folder of these files.
std::filesystem::path startValueFolder();

/// Holds what was read: model's id -> "parameters" as in a preset, and what was wrong.
struct StartValueReading {
    std::map<std::string, nlohmann::json, std::less<>> values;
    Errors errors;
};

StartValueReading readStartValues(const std::filesystem::path& folder);

/// Writes the start values of a model; null removes its file.
Result<void> writeStartValues(const std::filesystem::path& folder, const std::string& model,
                              const nlohmann::json& parameters);

} // namespace patina
