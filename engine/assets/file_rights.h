// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace patina {

using FileSet = std::set<std::string, std::less<>>; ///< holds full paths with forward slashes

/// Says which files may be read that other files name, and that the user did not name.
struct FileRights {
    /// Lists meshes and environment images that must not be read, because they lie outside the
    /// folder of the file that names them. Images on surfaces have a flag of their own
    /// (`TextureUse::outside`).
    FileSet withheld{};
    /// Lists files that meshes link to and that are read although they lie outside the mesh's
    /// folder.
    FileSet links{};
    bool allowsEveryLink = false;

    friend bool operator==(const FileRights&, const FileRights&) = default;
};

} // namespace patina
