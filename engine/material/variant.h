// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "material/preset_file.h"

namespace patina {

// A variant is a preset that names another one as its parent and keeps what differs from it: its
// file is a JSON merge patch (RFC 7396) of the parent's, whose name and parked values it does not
// inherit. In memory it is whole like any other material.

/// Presets may stand above each other so many times.
inline constexpr int maxParents = 8;

/// Returns the full path of the preset that a material is a variant of; empty where it is none.
std::string parentOf(const Material& material);

/// Makes a material a variant of a preset, or of none where the path is empty.
void setParent(Material& material, const std::string& file);

/// Reads a preset whose document names a parent, that one and those above it.
Checked<PresetReading> readVariant(const LocatedJson& document, const Catalog& catalog,
                                   const ReadingRights& rights);

/// Returns the preset's JSON without what the parent says too; whole and without a parent where
/// that cannot be read or would be this very file.
nlohmann::json variantJson(const Material& material, const std::filesystem::path& file,
                           const Catalog& catalog);

/// Returns which presets above this one would not be read with these rights.
OutsideFiles parentsOutside(const std::filesystem::path& file, const ReadingRights& rights);

} // namespace patina
