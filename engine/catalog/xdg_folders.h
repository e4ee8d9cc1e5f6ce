// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace patina {

/// Return $XDG_DATA_HOME/patina and $XDG_CACHE_HOME/patina, or the defaults of the XDG Base
/// Directory Specification below $HOME. Paths that are not absolute are ignored, as it demands; the
/// result is empty when no other is left.
std::optional<std::filesystem::path> xdgDataFolder();
std::optional<std::filesystem::path> xdgCacheFolder();

} // namespace patina
