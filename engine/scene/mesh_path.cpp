// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh_path.h"

namespace patina {

namespace fs = std::filesystem;

std::optional<std::string_view> builtinName(std::string_view mesh) {
    constexpr std::string_view prefix = "builtin:";
    if (mesh.substr(0, prefix.size()) != prefix) {
        return std::nullopt;
    }
    return mesh.substr(prefix.size());
}

std::string meshFromFile(const std::string& mesh, const std::filesystem::path& folder) {
    if (mesh.empty() || builtinName(mesh)) {
        return mesh;
    }
    return (folder / fs::path(mesh)).lexically_normal().generic_string();
}

std::string meshForFile(const std::string& mesh, const std::filesystem::path& folder) {
    if (builtinName(mesh) || !fs::path(mesh).is_absolute()) {
        return mesh;
    }
    const fs::path relative = fs::path(mesh).lexically_relative(folder);
    return relative.empty() ? mesh : relative.generic_string();
}

Error missingPart(const std::string& mesh, const std::string& part) {
    return Error{mesh, 0, 0, "has no triangles of a material \"" + part + '"', {}};
}

} // namespace patina
