// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "catalog/json_text.h"
#include "material/material.h"
#include "material/reading_rights.h"

namespace patina {

/// Holds what reading a preset gave. Notes are things the user should know that lost nothing (an
/// unknown model whose values are parked, a value outside its range that was brought in, ...).
struct PresetReading {
    Material material;
    Errors notes;
    OutsideFiles outside;  ///< what it names and is not read
    bool readOnly = false; ///< written by a newer version: may be looked at, not saved over
    std::vector<std::filesystem::path> parents{}; ///< of a variant, the nearest first
};

/// Reads a material from the value at `pointer` of a document (a preset inside a scene), whose
/// parent it does not read: what it has not is at its default. Paths of
/// images start at the document's folder and are absolute in the value.
Checked<PresetReading> materialFromJson(const LocatedJson& document, const std::string& pointer,
                                        const Catalog& catalog, const ReadingRights& rights = {});

/// Returns the preset's JSON, every parameter written; paths of images relative to `folder`, or as
/// they are where it is empty.
nlohmann::json toJson(const Material& material, const std::filesystem::path& folder = {});

Checked<PresetReading> readPreset(const std::filesystem::path& path, const Catalog& catalog,
                                  const ReadingRights& rights = {});

/// Returns the JSON of a preset's file: of a variant (see variant.h) only what it does not share
/// with its parent.
nlohmann::json presetJson(const Material& material, const std::filesystem::path& file,
                          const Catalog& catalog);

Result<void> writePreset(const std::filesystem::path& path, const Material& material,
                         const Catalog& catalog);

} // namespace patina
