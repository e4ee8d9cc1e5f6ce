// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace patina {

/// Describes a file or folder at one moment, so that a change of its identity or content makes it
/// differ. Of a folder it holds only identity and rights, since its files have their own states.
struct PathState {
    std::string path;
    std::uint64_t device = 0;
    std::uint64_t number = 0; ///< is that of its inode
    std::uint32_t mode = 0;
    std::int64_t bytes = 0;
    std::int64_t seconds = 0; ///< is the time of its last change (ctime); 0 for a folder
    std::int64_t nanoseconds = 0;

    friend bool operator==(const PathState&, const PathState&) = default;
};

using PathStates = std::vector<PathState>;

/// Appends the states of a folder, all folders below it and their files that are part of blocks,
/// sorted by path. Appends nothing if the folder does not exist.
void addPathStates(const std::filesystem::path& folder, PathStates& states);

} // namespace patina
