// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "material/preset_file.h"

namespace patina {

// A variant is a preset that names another one as its parent and keeps what differs from it: its
// file is a JSON merge patch (RFC 7396) of the parent's, whose name, parked values and extras it
// does not inherit. In memory it is complete like any other material.

/// Limits how many parents a preset may have above it.
inline constexpr int maxParents = 8;

/// Returns the full path of the preset that a material is a variant of; empty where it is none.
std::string parentOf(const Material& material);

/// Makes a material a variant of a preset, or of none where the path is empty.
void setParent(Material& material, const std::string& file);

/// Reads a preset whose document names a parent, together with that parent and those above it. It
/// is an error where one of them cannot be read, or is a variant of this preset.
Checked<PresetReading> readVariant(const LocatedJson& document, const Catalog& catalog,
                                   const ReadingRights& rights);

/// Returns the preset's JSON without what it shares with its parent. It is complete and names no
/// parent where the parent cannot be read, is this very file, or has this file above it.
nlohmann::json variantJson(const Material& material, const std::filesystem::path& file,
                           const Catalog& catalog);

/// Returns the first parent above this preset that may not be read with these rights; empty where
/// all may be.
OutsideFiles parentsOutside(const std::filesystem::path& file, const ReadingRights& rights);

} // namespace patina
