// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace patina {

/// A file or folder at one moment. It is another one, or another content, when this differs; of a
/// folder only which one it is and who may read it, since what is in it has states of its own.
struct PathState {
    std::string path;
    std::uint64_t device = 0;
    std::uint64_t number = 0; ///< of its inode
    std::uint32_t mode = 0;
    std::int64_t bytes = 0;
    std::int64_t seconds = 0; ///< of its last change
    std::int64_t nanoseconds = 0;

    friend bool operator==(const PathState&, const PathState&) = default;
};

using PathStates = std::vector<PathState>;

/// Appends a folder, all folders below it, and their files that blocks are made of; nothing when it
/// is not there.
void addPathStates(const std::filesystem::path& folder, PathStates& states);

} // namespace patina
