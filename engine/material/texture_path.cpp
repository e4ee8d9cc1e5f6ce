// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/texture_path.h"

#include "core/mesh_material.h"

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

std::string imageFromFile(const std::string& image, const std::filesystem::path& folder) {
    if (image.empty() || folder.empty() || isVertexColors(image)) {
        return image;
    }
    return (folder / std::filesystem::path(image)).lexically_normal().generic_string();
}

std::string imageForFile(const std::string& image, const std::filesystem::path& folder) {
    if (folder.empty() || !std::filesystem::path(image).is_absolute()) {
        return image;
    }
    const std::filesystem::path relative = std::filesystem::path(image).lexically_relative(folder);
    return relative.empty() ? image : relative.generic_string();
}

} // namespace patina
