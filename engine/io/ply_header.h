// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina {

/// True when the file begins as PLY and its header comes to an end. Assimp reads one that does
/// not for ever.
bool hasWholePlyHeader(const std::filesystem::path& file);

} // namespace patina
