// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "document/document.h"

namespace patina {

class FileActions;
class PresetLibrary;

/// Applies one preset of the library after another to a side, in the order of their names.
class LibrarySteps {
  public:
    LibrarySteps(Document& document, const PresetLibrary& library, FileActions& files)
        : document_(document), library_(library), files_(files) {}

    /// Applies the preset that is `by` places behind the one that was applied last, or else behind
    /// the one with the name of the side's material; after the last one comes the first. Without
    /// either it applies the first.
    void step(Side side, int by);

  private:
    Document& document_;
    const PresetLibrary& library_;
    FileActions& files_;
    /// Holds the file that was applied last, per side.
    std::array<std::filesystem::path, sides.size()> last_;
};

} // namespace patina
