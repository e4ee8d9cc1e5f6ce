// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace patina {

/// True for a path that a file may name without asking the user: relative, with forward slashes,
/// and not leading out of the file's own folder.
bool staysInFolder(std::string_view path);

/// Returns an image as a file names it, made absolute: relative paths start at the file's folder.
/// Without a folder it stays as it is.
std::string imageFromFile(const std::string& image, const std::filesystem::path& folder);

/// Returns the inverse: relative to the folder, with forward slashes.
std::string imageForFile(const std::string& image, const std::filesystem::path& folder);

} // namespace patina
