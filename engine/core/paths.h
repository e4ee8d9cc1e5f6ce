// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina {

/// Tells whether the path is the folder or below it, by their names alone: nothing is resolved.
/// Nothing is below an empty folder.
bool isWithin(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Tells the same of the places that both lead to, links resolved; false where they are circles.
bool leadsWithin(const std::filesystem::path& path, const std::filesystem::path& folder);

} // namespace patina
