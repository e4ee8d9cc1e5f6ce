// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>

#include "catalog/catalog.h"
#include "library/preset_entry.h"

namespace patina {

/// A folder of presets that the library shows, with those below it.
struct PresetFolder {
    std::filesystem::path path;
    bool shipped = false; ///< nothing in it is changed

    friend bool operator==(const PresetFolder&, const PresetFolder&) = default;
};

/// What reading the library's folders gave.
struct PresetsRead {
    std::vector<PresetPtr> entries;             ///< by name
    Errors errors;                              ///< of the files that cannot be read
    std::vector<std::filesystem::path> folders; ///< all that were looked through
};

/// Reads all presets of some folders. Those of `known` whose files are as they were are taken from
/// there. `soFar` is told now and then what was read.
PresetsRead readPresets(const std::vector<PresetFolder>& folders, const Catalog& catalog,
                        const std::vector<PresetPtr>& known,
                        const std::function<bool(const PresetsRead& read)>& soFar);

} // namespace patina
