// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "document/document.h"
#include "library/preset_entry.h"

namespace patina {

class FileActions;
class PresetLibrary;

/// Applies one preset of the library after another to a side.
class LibrarySteps {
  public:
    LibrarySteps(Document& document, const PresetLibrary& library, FileActions& files)
        : document_(document), library_(library), files_(files) {}

    /// Applies the preset that is `by` places behind the one that was applied last, or else behind
    /// the one with the name of the side's material; after the last one comes the first. Without
    /// either it applies the first. They are in the order of their names.
    void step(Side side, int by);

    /// Does so among these presets. Returns the one that is applied; null where there is none.
    PresetPtr step(Side side, int by, const std::vector<PresetPtr>& presets);

  private:
    Document& document_;
    const PresetLibrary& library_;
    FileActions& files_;
    /// Holds the file that was applied last, per side.
    std::array<std::filesystem::path, sides.size()> last_;
};

} // namespace patina
