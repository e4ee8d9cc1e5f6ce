// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/catalog.h"
#include "catalog/xdg_folders.h"
#include "core/paths.h"

#include <cstdlib>
#include <map>
#include <mutex>
#include <optional>
#include <set>

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

/// Returns the folder that `make install` fills, relative to the running program.
fs::path installedFolder() {
    std::error_code status;
    const fs::path program = fs::read_symlink("/proc/self/exe", status);
    return (program.parent_path() / PATINA_DATA_FROM_PROGRAM).lexically_normal();
}

std::optional<fs::path> absolutePath(const char* variable) {
    const auto path = environmentPath(variable);
    return path && path->is_absolute() ? path : std::nullopt;
}

std::optional<fs::path> userFolder(const char* variable, const fs::path& belowHome) {
    if (const auto folder = absolutePath(variable)) {
        return *folder / "patina";
    }
    const auto home = absolutePath("HOME");
    return home ? std::optional(*home / belowHome / "patina") : std::nullopt;
}

/// Returns what was below the folder when this was first asked: an author may add to it.
const std::set<fs::path>& shippedFiles(const fs::path& presets) {
    static std::mutex mutex;
    static std::map<fs::path, std::set<fs::path>> known;
    const std::lock_guard lock(mutex);
    const auto [found, isNew] = known.try_emplace(presets);
    if (isNew) {
        std::error_code ignored; // of a folder that cannot be read: there are none
        for (const auto& entry : fs::recursive_directory_iterator(presets, ignored)) {
            found->second.insert(fs::weakly_canonical(entry.path(), ignored));
        }
    }
    return found->second;
}

} // namespace

std::optional<fs::path> xdgDataFolder() {
    return userFolder("XDG_DATA_HOME", fs::path(".local") / "share");
}

std::optional<fs::path> xdgCacheFolder() {
    return userFolder("XDG_CACHE_HOME", ".cache");
}

std::filesystem::path dataFolder() {
    if (const auto chosen = environmentPath("PATINA_DATA_DIR")) {
        return *chosen;
    }
    const fs::path installed = installedFolder();
    const fs::path sources = PATINA_SOURCE_FOLDER;
    return !isDataFolder(installed) && isDataFolder(sources) ? sources : installed;
}

bool isShippedPreset(const std::filesystem::path& file) {
    std::error_code circle; // of links, which leads nowhere
    const fs::path path = fs::weakly_canonical(file, circle);
    const auto own = xdgDataFolder(); // where Patina may be installed as well
    std::error_code status;
    return !file.empty() && !circle && shippedFiles(dataFolder() / "presets").contains(path) &&
           fs::is_regular_file(path, status) && !(own && leadsWithin(path, *own));
}

std::filesystem::path defaultSceneFile() {
    return dataFolder() / "presets" / "default.patina-scene.json";
}

std::vector<fs::path> shippedScenes() {
    std::vector<fs::path> scenes;
    std::error_code ignored; // of a folder that cannot be read: there are none
    for (const auto& entry : fs::directory_iterator(dataFolder() / "presets", ignored)) {
        if (entry.path().string().ends_with(".patina-scene.json")) {
            scenes.push_back(entry.path());
        }
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

std::vector<BlockRoot> standardBlockRoots() {
    std::vector<BlockRoot> roots{{dataFolder() / "shaders", true}};
    if (const auto user = xdgDataFolder()) {
        roots.push_back({*user / "shaders", false});
    }
    return roots;
}

} // namespace patina
