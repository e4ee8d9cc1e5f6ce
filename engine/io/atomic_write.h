// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "core/error.h"

namespace patina {

/// Writes a whole file or nothing: into a new file beside it, flushed to the disk, then renamed.
/// A link is followed. Errors name the file and the cause; the old file is then intact.
Result<void> writeAtomically(const std::filesystem::path& file, std::string_view bytes);

} // namespace patina
