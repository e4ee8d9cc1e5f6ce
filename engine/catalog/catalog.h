// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "catalog/block.h"
#include "core/error.h"

namespace patina {

/// Is a folder that holds blocks: <root>/<kind>/<id>.json + <id>.glsl.
struct BlockRoot {
    std::filesystem::path folder;
    bool shipped = true;

    friend bool operator==(const BlockRoot&, const BlockRoot&) = default;
};

/// Holds every block that could be read, and every mistake that was found. loadCatalog makes it.
struct Catalog {
    /// Keeps the order of the search; lib/ and passes/ come from the first.
    std::vector<BlockRoot> roots;
    std::vector<Block> blocks; ///< are sorted by kind, then id
    Errors errors;

    /// Returns the block with that id, else the one that had it before; null where there is none.
    const Block* find(std::string_view kind, std::string_view id) const;

    /// Returns all blocks of one kind, sorted by label.
    std::vector<const Block*> ofKind(std::string_view kind) const;

    friend bool operator==(const Catalog&, const Catalog&) = default;
};

/// Reads all blocks under the roots. A block with a mistake is left out and its mistakes are in
/// `errors`; the rest work. A block id that an earlier root already has is such a mistake.
/// A root that is missing or unreadable is an error only when it is shipped.
Catalog loadCatalog(std::span<const BlockRoot> roots);

/// Returns where the blocks are: the shipped folder ($PATINA_DATA_DIR/shaders, beside the sources
/// in a build tree, or the installed one) and $XDG_DATA_HOME/patina/shaders.
std::vector<BlockRoot> standardBlockRoots();

/// Returns the folder that holds shaders/, presets/ and schemas/.
std::filesystem::path dataFolder();

/// Tells whether a file is one of the presets and scenes that ship, links followed. It compares
/// with the files that existed when the program first asked.
bool isShippedPreset(const std::filesystem::path& file);

/// Returns the file of the scene that a new document starts with.
std::filesystem::path defaultSceneFile();

/// Returns the files of the scenes that ship, sorted by name.
std::vector<std::filesystem::path> shippedScenes();

} // namespace patina
