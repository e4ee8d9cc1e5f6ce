// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"

#include <cstdlib>
#include <optional>

namespace patina {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> environmentPath(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr || *value == '\0') {
        return std::nullopt;
    }
    return fs::path(value);
}

bool isDataFolder(const fs::path& folder) {
    std::error_code status;
    return fs::is_directory(folder / "schemas", status);
}

/// The folder `make install` fills, seen from the program that runs.
fs::path installedFolder() {
    std::error_code status;
    const fs::path program = fs::read_symlink("/proc/self/exe", status);
    return (program.parent_path() / PATINA_DATA_FROM_PROGRAM).lexically_normal();
}

/// The XDG Base Directory Specification ignores relative paths.
std::optional<fs::path> userDataFolder() {
    if (const auto xdg = environmentPath("XDG_DATA_HOME"); xdg && xdg->is_absolute()) {
        return *xdg / "patina";
    }
    if (const auto home = environmentPath("HOME")) {
        return *home / ".local" / "share" / "patina";
    }
    return std::nullopt;
}

} // namespace

std::filesystem::path dataFolder() {
    if (const auto chosen = environmentPath("PATINA_DATA_DIR")) {
        return *chosen;
    }
    const fs::path installed = installedFolder();
    const fs::path sources = PATINA_SOURCE_FOLDER;
    return !isDataFolder(installed) && isDataFolder(sources) ? sources : installed;
}

std::vector<BlockRoot> standardBlockRoots() {
    std::vector<BlockRoot> roots{{dataFolder() / "shaders", true}};
    if (const auto user = userDataFolder()) {
        roots.push_back({*user / "shaders", false});
    }
    return roots;
}

} // namespace patina
