// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace patina::benchmarks {

inline std::filesystem::path program(const char* name) {
    return std::filesystem::path(PATINA_BINARY_DIR) / "bin" / name;
}

} // namespace patina::benchmarks
