// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/preset_folder.h"

#include <filesystem>
#include <map>

#include <fmt/format.h>

namespace patina {

std::string nameInFolder(const std::string& preset, std::string_view suffix) {
    constexpr std::string_view ending = ".patina.json";
    const std::string name = std::filesystem::path(preset).filename().string();
    const std::string stem = name.ends_with(ending) ? name.substr(0, name.size() - ending.size())
                                                    : std::filesystem::path(name).stem().string();
    return stem + std::string(suffix);
}

Result<void> prepareFolder(const std::string& folder, std::span<const std::string> presets,
                           std::string_view suffix, std::string_view what) {
    std::map<std::string, std::string> owners;
    for (const std::string& preset : presets) {
        const auto [owner, isNew] = owners.try_emplace(nameInFolder(preset, suffix), preset);
        if (!isNew) {
            return tl::unexpected(
                Error{preset, 0, 0,
                      fmt::format("its {} {} would take the place of that of {}", what,
                                  owner->first, owner->second),
                      "presets whose files have different names, or a folder for each"});
        }
    }
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed && !std::filesystem::is_directory(folder)) {
        return tl::unexpected(
            Error{folder, 0, 0, "the folder cannot be made: " + failed.message(), {}});
    }
    return {};
}

bool isFolder(const std::string& output) {
    std::error_code unknown; // a path that cannot be examined is no folder
    return output.ends_with('/') || std::filesystem::is_directory(output, unknown);
}

} // namespace patina
