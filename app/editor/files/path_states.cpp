// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/path_states.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <system_error>

#include <sys/stat.h>

namespace patina {
namespace {

namespace fs = std::filesystem;

std::optional<PathState> stateOf(const fs::path& path) {
    struct stat found = {};
    if (::stat(path.c_str(), &found) != 0) {
        return std::nullopt;
    }
    PathState state{path.string(), found.st_dev, found.st_ino, found.st_mode, 0, 0, 0};
    if (!S_ISDIR(found.st_mode)) {
        state.bytes = found.st_size;
        state.seconds = found.st_ctim.tv_sec; // ctime changes with rights, too
        state.nanoseconds = found.st_ctim.tv_nsec;
    }
    return state;
}

/// Leaves out backup copies and logs.
bool isPartOfBlocks(const fs::path& path) {
    constexpr auto endings = std::to_array<std::string_view>({".json", ".glsl", ".vert", ".frag"});
    return std::find(endings.begin(), endings.end(), path.extension().string()) != endings.end();
}

void add(const fs::path& path, PathStates& states) {
    if (auto state = stateOf(path)) {
        states.push_back(std::move(*state));
    }
}

} // namespace

void addPathStates(const fs::path& folder, PathStates& states) {
    const auto first = static_cast<std::ptrdiff_t>(states.size());
    add(folder, states);
    std::error_code failed; // a folder that cannot be listed counts as empty
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied,
                                        failed);
    for (const fs::recursive_directory_iterator end; !failed && at != end; at.increment(failed)) {
        std::error_code gone;
        if (at->is_directory(gone) || isPartOfBlocks(at->path())) {
            add(at->path(), states);
        }
    }
    std::sort(states.begin() + first, states.end(),
              [](const PathState& a, const PathState& b) { return a.path < b.path; });
}

} // namespace patina
