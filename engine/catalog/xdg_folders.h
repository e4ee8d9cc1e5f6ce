// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace patina {

/// $XDG_DATA_HOME/patina and $XDG_CACHE_HOME/patina, or what the XDG Base Directory Specification
/// puts in their place below $HOME. Paths that are not absolute are ignored, as it says; nothing
/// when no other is left.
std::optional<std::filesystem::path> xdgDataFolder();
std::optional<std::filesystem::path> xdgCacheFolder();

} // namespace patina
