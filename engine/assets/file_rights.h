// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

namespace patina {

using FileSet = std::set<std::string, std::less<>>; ///< full paths with forward slashes

/// Holds what is read of that which files name rather than the user.
struct FileRights {
    /// Meshes and pictures that are not read: somebody named them who may not. Of images on
    /// surfaces each says so itself (`TextureUse::outside`).
    FileSet withheld{};
    /// Links, which lie outside the folders of the meshes that name them, and are read.
    FileSet links{};
    bool allowsEveryLink = false;

    friend bool operator==(const FileRights&, const FileRights&) = default;
};

} // namespace patina
