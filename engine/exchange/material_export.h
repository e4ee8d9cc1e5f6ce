// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/exported_look.h"

namespace patina {

/// Describes a file format of other programs in which materials can be written.
struct ExchangeFormat {
    std::string_view ending; ///< is that of its files, with the dot
    std::string_view label;
    KnownLooks looks;
};

std::span<const ExchangeFormat> exchangeFormats();

/// Returns the format of a file by its ending; null for none.
const ExchangeFormat* exchangeFormatOf(const std::filesystem::path& file);

/// Says what became of each of the exported materials.
struct MaterialExport {
    std::vector<std::string> names;             ///< are those that they have in the file
    std::vector<std::vector<ExportLine>> lines; ///< are by the same order
};

/// Is the problem of an export that was cancelled.
inline constexpr const char* cancelledExport = "the export was cancelled";

/// Writes materials into a file of another program by its ending, and the images that they have
/// into a folder beside it; glTF's get a ball each. Every file is written whole or not at all.
/// Fails where a material's model is not known, where it was cancelled (cancelledExport), or where
/// a file cannot be written.
Result<MaterialExport> exportMaterials(const std::filesystem::path& file,
                                       const std::vector<Material>& materials,
                                       const Catalog& catalog, const Progress& progress);

/// Returns one line for each thing: "exact  Roughness: roughnessFactor 0.5".
std::string exportText(const std::vector<ExportLine>& lines);

} // namespace patina
