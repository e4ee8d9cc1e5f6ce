// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "catalog/json_text.h"
#include "material/material.h"
#include "material/reading_rights.h"

namespace patina {

/// Holds what reading a preset gave. Its notes are what the user should know although nothing is
/// lost: an unknown model whose values are kept, a value that was brought into its range, ...
struct PresetReading {
    Material material;
    Errors notes;
    OutsideFiles outside;  ///< holds what it names and is not read
    bool readOnly = false; ///< says that a newer version wrote it: do not save over it
    std::vector<std::filesystem::path> parents{}; ///< are those of a variant, nearest first
};

/// Reads a material from the value at `pointer` of a document, as a preset inside a scene. It does
/// not read a parent: what the value does not have is at its default. Paths of images start at the
/// document's folder and are absolute in the material.
Checked<PresetReading> materialFromJson(const LocatedJson& document, const std::string& pointer,
                                        const Catalog& catalog, const ReadingRights& rights = {});

/// Returns the preset's JSON with every parameter. Paths of images are relative to `folder`, or
/// unchanged where it is empty.
nlohmann::json toJson(const Material& material, const std::filesystem::path& folder = {});

Checked<PresetReading> readPreset(const std::filesystem::path& path, const Catalog& catalog,
                                  const ReadingRights& rights = {});

/// Returns the JSON of a preset's file. A variant (see variant.h) has only what it does not share
/// with its parent.
nlohmann::json presetJson(const Material& material, const std::filesystem::path& file,
                          const Catalog& catalog);

Result<void> writePreset(const std::filesystem::path& path, const Material& material,
                         const Catalog& catalog);

} // namespace patina
