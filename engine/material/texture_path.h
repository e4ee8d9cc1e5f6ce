// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace patina {

/// Tells whether a file may name this path without asking the user: it is relative, has forward
/// slashes, and does not lead out of the file's own folder.
bool staysInFolder(std::string_view path);

/// Returns the path of an image that a file names, made absolute: relative paths start at the
/// file's folder. Without a folder it is unchanged.
std::string imageFromFile(const std::string& image, const std::filesystem::path& folder);

/// Returns the inverse: relative to the folder, with forward slashes.
std::string imageForFile(const std::string& image, const std::filesystem::path& folder);

} // namespace patina
