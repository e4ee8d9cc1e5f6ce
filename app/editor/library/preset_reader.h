// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "catalog/catalog.h"
#include "library/preset_entry.h"

namespace patina {

/// Is a folder whose presets, and those below it, are in the library.
struct PresetFolder {
    std::filesystem::path path;
    bool shipped = false; ///< tells that nothing in it may be changed

    friend bool operator==(const PresetFolder&, const PresetFolder&) = default;
};

/// Holds what was read from the library's folders.
struct PresetsRead {
    std::vector<PresetPtr> entries; ///< are sorted by name
    Errors errors;                  ///< are those of files that cannot be read
    /// Holds all folders that were read, with those below them.
    std::vector<std::filesystem::path> folders;
};

/// Reads all presets of some folders; takes those of `known` whose files have not changed. Calls
/// `soFar` now and then with what was read, and ends early if that returns false.
PresetsRead readPresets(const std::vector<PresetFolder>& folders, const Catalog& catalog,
                        const std::vector<PresetPtr>& known,
                        const std::function<bool(const PresetsRead& read)>& soFar);

} // namespace patina
