// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>

#include "catalog/catalog.h"
#include "core/error.h"

namespace patina {

/// Finds the mistakes in the GLSL of blocks, those of folders that no catalogue has as well.
class ShaderMistakes {
  public:
    explicit ShaderMistakes(const Catalog& catalog) : catalog_(catalog) {}

    /// Returns what the catalogue and the compiler say of the block of a sound descriptor, in a
    /// program that draws with it; nothing where its folder is not named after a kind of block.
    Errors of(const std::filesystem::path& descriptor);

  private:
    const Catalog& catalogWith(const std::filesystem::path& root);

    const Catalog& catalog_;
    std::map<std::filesystem::path, Catalog> others_; ///< are by the root that each has as well
};

} // namespace patina
