// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/texture_path.h"

#include <filesystem>

namespace patina {

bool staysInFolder(std::string_view path) {
    // A colon or a backslash is a drive or a separator where the file may be opened next.
    if (path.empty() || path.find_first_of(":\\") != std::string_view::npos ||
        path.find('\0') != std::string_view::npos) {
        return false;
    }
    const std::filesystem::path normal = std::filesystem::path(path).lexically_normal();
    return !normal.is_absolute() && *normal.begin() != "..";
}

} // namespace patina
