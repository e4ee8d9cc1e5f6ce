// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "material/file_header.h"
#include "material/reading_rights.h"
#include "sheet/contact_sheet.h"

namespace patina {

/// What a file of a sheet says it is, and how its name ends.
inline constexpr FileFormat sheetFormat{"patina.sheet", 1, "sheet"};
inline constexpr std::string_view sheetEnding = ".patina-sheet.json";

struct SheetReading {
    Sheet sheet;
    Errors notes;
    OutsideFiles outside{}; ///< the preset, where it may not be read
    bool readOnly = false;  ///< it was written by a newer Patina
};

/// Reads a sheet. Its preset is a path from the file's folder. Every mistake has its line and
/// column.
Checked<SheetReading> readSheet(const std::filesystem::path& path,
                                const ReadingRights& rights = {});

/// Returns the sheet's JSON; its preset relative to `folder`.
nlohmann::json toJson(const Sheet& sheet, const std::filesystem::path& folder);

Result<void> writeSheet(const std::filesystem::path& path, const Sheet& sheet);

/// Returns the sheets that ship, by their files' names.
std::vector<std::filesystem::path> shippedSheets();

/// Returns the word of a number in files and on the command line: "time", "error", "albedo".
std::string_view wordOf(CellNumber number);
std::optional<CellNumber> cellNumberOf(std::string_view word);

/// Returns what is wrong with a sheet whatever it is of: steps, sizes, numbers of cells.
Errors limitMistakes(const Sheet& sheet);

} // namespace patina
