// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/material_images.h"

#include <algorithm>
#include <filesystem>

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Returns the full path of an image with forward slashes.
std::string placeOf(const fs::path& path, const MeshFolder& folder) {
    std::error_code failed;
    const fs::path mesh = fs::absolute(folder.file(), failed);
    return (mesh.parent_path() / path).lexically_normal().generic_string();
}

} // namespace

std::string fileNameIn(const std::string& path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

bool addImage(MeshMaterial& material, const std::string& word, std::string path,
              MeshFolder& folder) {
    std::ranges::replace(path, '\\', '/');
    const std::string beside = fs::path(path).filename().string();
    for (const std::string& place : {path, beside}) {
        if (!place.empty() && place.find('\0') == std::string::npos && folder.open(place)) {
            material.images[word] = placeOf(place, folder);
            return true;
        }
    }
    return false;
}

} // namespace patina
