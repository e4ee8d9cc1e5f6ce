// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/error.h"

namespace patina {

/// Far more than anybody writes, and little enough to be read in a moment.
constexpr std::size_t maxShaderBytes = std::size_t(1) << 20;

/// The text of a shader's file: a file, no larger than that, without a NUL byte (at which a driver
/// takes the text to end). A byte order mark before it is left out.
Result<std::string> readShaderFile(const std::filesystem::path& file);

} // namespace patina
