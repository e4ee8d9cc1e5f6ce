// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "catalog/block.h"
#include "core/error.h"

namespace patina {

/// A folder that holds blocks: <root>/<kind>/<id>.json + <id>.glsl.
struct BlockRoot {
    std::filesystem::path folder;
    bool shipped = true;

    friend bool operator==(const BlockRoot&, const BlockRoot&) = default;
};

/// Every block that could be read, and every mistake that was met. A value; made by loadCatalog.
struct Catalog {
    std::vector<BlockRoot> roots; ///< as they were searched; lib/ and passes/ come from the first
    std::vector<Block> blocks;    ///< sorted by kind, then id
    Errors errors;

    /// The block with that id, else the one that had it before; null where there is none.
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

/// The folder that holds shaders/, presets/ and schemas/.
std::filesystem::path dataFolder();

/// Tells whether a file is one of the presets and scenes that ship, links and all: of those that
/// were there when the program first asked.
bool isShippedPreset(const std::filesystem::path& file);

/// The scene that a new document starts as.
std::filesystem::path defaultSceneFile();

/// Returns the scenes that ship, by their files' names.
std::vector<std::filesystem::path> shippedScenes();

} // namespace patina
