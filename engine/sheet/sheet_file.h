// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "material/file_header.h"
#include "material/reading_rights.h"
#include "sheet/contact_sheet.h"

namespace patina {

inline constexpr FileFormat sheetFormat{"patina.sheet", 1, "sheet"};
inline constexpr std::string_view sheetEnding = ".patina-sheet.json";

/// Holds what reading a sheet gave; its notes are about things that lost nothing.
struct SheetReading {
    Sheet sheet;
    Errors notes;
    OutsideFiles outside{}; ///< holds the preset where it may not be read
    bool readOnly = false;  ///< says that a newer Patina wrote it
};

/// Reads a sheet. The file names its preset relative to its folder; the value has the full path.
/// Every mistake has its line and column.
Checked<SheetReading> readSheet(const std::filesystem::path& path,
                                const ReadingRights& rights = {});

/// Returns the sheet's JSON, whose preset is a path relative to `folder`.
nlohmann::json toJson(const Sheet& sheet, const std::filesystem::path& folder);

Result<void> writeSheet(const std::filesystem::path& path, const Sheet& sheet);

/// Returns the files of the sheets that ship, sorted; empty where their folder cannot be read.
std::vector<std::filesystem::path> shippedSheets();

/// Pairs a kind of axis with its word: the key that holds its steps in files, and its name on the
/// command line, where a value is called by its id instead.
struct AxisWord {
    AxisKind kind;
    const char* word;
};
inline constexpr std::array axisWords{
    AxisWord{AxisKind::Value, "value"}, AxisWord{AxisKind::Models, "models"},
    AxisWord{AxisKind::Accuracy, "accuracy"}, AxisWord{AxisKind::Lights, "lights"},
    AxisWord{AxisKind::Environments, "environments"}};

/// Returns the word for a number in files and on the command line: "time", "error" or "albedo".
std::string_view wordOf(CellNumber number);
std::optional<CellNumber> cellNumberOf(std::string_view word);

/// Returns what is wrong with a sheet whatever scene it shows: its steps, its cells' size, and its
/// size as a whole. The `file` of each error is a JSON pointer into the sheet.
Errors limitMistakes(const Sheet& sheet);

} // namespace patina
