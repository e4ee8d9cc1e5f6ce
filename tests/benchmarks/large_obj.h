// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina::benchmarks {

/// Writes a sphere with waves on it, just under a million triangles, as a grid of quads cut in two.
void writeLargeObj(const std::filesystem::path& path);

} // namespace patina::benchmarks
