// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/reading_rights.h"

#include <algorithm>

#include "catalog/catalog.h"
#include "catalog/xdg_folders.h"
#include "core/paths.h"
#include "material/texture_path.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Tells whether a file is in one of Patina's own folders.
bool isPatinas(const fs::path& file) {
    const auto user = xdgDataFolder();
    return leadsWithin(file, dataFolder()) || (user && leadsWithin(file, *user));
}

} // namespace

fs::path referenceFolder(const fs::path& file) {
    return file.empty() ? file : fs::absolute(file).lexically_normal().parent_path();
}

References::References(const fs::path& file, const ReadingRights& rights)
    : base_(referenceFolder(file)), rights_(rights) {}

std::string References::fullPath(std::string_view named) const {
    return imageFromFile(std::string(named), base_);
}

bool References::isInside(std::string_view named) const {
    const fs::path folder = rights_.folder.empty() ? base_ : rights_.folder;
    if (folder.empty()) {
        return staysInFolder(named);
    }
    const bool isPlain = !named.empty() && named.find_first_of(":\\") == std::string_view::npos &&
                         named.find('\0') == std::string_view::npos;
    const std::string file = fullPath(named);
    return isPlain && (leadsWithin(file, folder) || isPatinas(file));
}

bool References::mayRead(std::string_view named, OutsideFile::Kind kind) {
    if (rights_.everything || rights_.allowed.contains(fullPath(named)) || isInside(named)) {
        return true;
    }
    if (!named.empty()) {
        add({{kind, fullPath(named)}});
    }
    return false;
}

ReadingRights References::rightsOf(std::string_view preset) const {
    ReadingRights rights = rights_;
    if (!isInside(preset)) { // it is another one's, with images of its own
        rights.folder.clear();
    } else if (rights.folder.empty()) {
        rights.folder = base_;
    }
    return rights;
}

void References::add(const OutsideFiles& others) {
    for (const OutsideFile& other : others) {
        if (std::ranges::find(outside_, other) == outside_.end()) {
            outside_.push_back(other);
        }
    }
}

} // namespace patina
