// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/texture_path.h"

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

bool staysInFolder(std::string_view path, const std::filesystem::path& folder) {
    if (!staysInFolder(path) || folder.empty()) {
        return staysInFolder(path);
    }
    std::error_code noFolder;
    std::error_code circle; // of links, which leads nowhere
    const std::filesystem::path from = std::filesystem::weakly_canonical(folder, noFolder);
    const std::filesystem::path to = std::filesystem::weakly_canonical(folder / path, circle);
    return noFolder || circle || staysInFolder(to.lexically_relative(from).generic_string());
}

std::string imageFromFile(const std::string& image, const std::filesystem::path& folder) {
    if (image.empty() || folder.empty()) {
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
