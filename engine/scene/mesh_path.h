// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/error.h"

namespace patina {

/// Returns "sphere" for "builtin:sphere"; nothing for the path of a file.
std::optional<std::string_view> builtinName(std::string_view mesh);

/// Returns the path of a mesh that a scene file names, made absolute: relative paths start at the
/// scene's folder. The name of a mesh made by code is unchanged.
std::string meshFromFile(const std::string& mesh, const std::filesystem::path& folder);

/// Returns the inverse: relative to the folder, with forward slashes.
std::string meshForFile(const std::string& mesh, const std::filesystem::path& folder);

/// Returns the error for an object whose mesh has no triangles of the material that it names.
Error missingPart(const std::string& mesh, const std::string& part);

} // namespace patina
