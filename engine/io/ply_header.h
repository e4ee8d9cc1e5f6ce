// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina {

/// Tells whether the file begins as PLY and its header comes to an end. Assimp would read a file
/// without such a header for ever.
bool hasWholePlyHeader(const std::filesystem::path& file);

} // namespace patina
