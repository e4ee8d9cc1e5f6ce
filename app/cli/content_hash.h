// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "catalog/catalog.h"

namespace patina {

/// Returns a hash of what decides how a preset looks: its file, those of its parents, and the
/// images that it names and may read; of a block, its descriptor and its GLSL. A file that cannot
/// be read counts as an empty one.
std::string presetHash(const std::string& preset, const Catalog& catalog, bool allowsOutside);

/// Returns a hash of every file of the blocks, and of what they include.
std::string blocksHash(std::span<const BlockRoot> roots);

/// Returns a hash of a file's content; that of an empty one where it cannot be read.
std::string fileHash(const std::filesystem::path& file);

/// Returns a hash of texts, in which their order and their bounds count.
std::string textsHash(std::span<const std::string> texts);

} // namespace patina
