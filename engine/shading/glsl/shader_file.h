// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "core/error.h"

namespace patina {

/// Limits the size of a shader's file: nobody writes as much, and it is still read in a moment.
constexpr std::size_t maxShaderBytes = std::size_t(1) << 20;

/// Reads the text of a shader's file. A file that is larger than maxShaderBytes, or has a NUL byte
/// (at which a driver takes the text to end), is an error. A byte order mark is left out.
Result<std::string> readShaderFile(const std::filesystem::path& file);

} // namespace patina
