// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "document/document.h"

namespace patina {

class FileActions;
class PresetLibrary;

/// Puts one preset of the library after another on a side, in the order of their names.
class LibrarySteps {
  public:
    LibrarySteps(Document& document, const PresetLibrary& library, FileActions& files)
        : document_(document), library_(library), files_(files) {}

    /// Puts the preset there that is `by` behind the one that was put there last, or whose name the
    /// side's material has; from the last one on to the first.
    void step(Side side, int by);

  private:
    Document& document_;
    const PresetLibrary& library_;
    FileActions& files_;
    std::array<std::filesystem::path, sides.size()> last_; ///< by side
};

} // namespace patina
