// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace patina {

/// Is a JSON document that remembers where each of its values is in the file.
struct LocatedJson {
    struct Place {
        int line = 0;
        int column = 0;
    };

    std::string file; ///< is the path as the user knows it
    nlohmann::json value;
    /// Maps a JSON pointer to the start of its value.
    std::unordered_map<std::string, Place> places;

    /// Returns an error at the value that a JSON pointer names ("" is the whole document).
    Error error(const std::string& pointer, std::string problem, std::string expected = {}) const;
};

/// Limits what is read: a file is never trusted.
struct JsonLimits {
    std::size_t bytes = 8u << 20;
    int depth = 64;
};

/// Parses strict JSON: finite numbers only, no repeated keys, UTF-8, within the limits.
Result<LocatedJson> parseJson(std::string_view text, std::string file, const JsonLimits& = {});

/// Reads and parses a file; errors name it.
Result<LocatedJson> readJson(const std::filesystem::path& path, const JsonLimits& = {});

/// Writes JSON in the project's only style: sorted keys, two spaces, floats as the shortest text
/// that reads back as the same float, arrays of numbers on one line, a final newline.
std::string writeJson(const nlohmann::json& value);

} // namespace patina
