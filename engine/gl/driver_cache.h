// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "core/error.h"

namespace patina::gl {

/// Mesa maps the index of its cache of programs as a sparse file, and the process ends with SIGBUS
/// when a page of it finds no room on the disk. This function reserves the disk space of the index
/// before Mesa maps it, so that the disk may become full later. Where there is no space, or the
/// folder cannot be written to, Mesa is told to keep no cache. It must be called before any other
/// call to OpenGL; only the first call does anything.
void prepareDriverCache();

/// Returns why the driver keeps no cache; nothing unless prepareDriverCache() had to turn it off.
const std::optional<Error>& driverCacheNote();

/// Allocates disk space for the index in a folder of Mesa's cache; the folder is made when it is
/// not there. The content of an existing index is kept.
Result<void> reserveCacheIndex(const std::filesystem::path& folder);

} // namespace patina::gl
