// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "assets/asset_client.h"
#include "measure/cells/cell_maker.h"
#include "sheet/sheet_picture.h"
#include "sheet/sheet_table.h"

namespace patina {

/// Tells what a sheet is written as: a picture in display values, one in linear light, or a table.
enum class SheetForm { Display, Linear, Table };

/// Returns the form by the ending of a file's name, in capitals or not: ".csv" is a table, ".exr"
/// and ".hdr" are linear, and every other one is a picture in display values.
SheetForm sheetFormOf(const std::filesystem::path& file);

/// Makes all cells of a sheet and puts them into a picture or a table.
class SheetMaker {
  public:
    /// Keeps references to the plan and the cells' maker, which must outlive it. A table of a sheet
    /// without numbers gets all of them.
    SheetMaker(const SheetPlan& plan, Sheet sheet, SheetForm form, CellMaker& cells);

    /// Makes all cells; those that cannot be drawn say why. Calls `goesOn` before each of them and
    /// while one is measured, and returns false where that does. It is an error where no cell could
    /// be made, or where an environment's picture cannot be read.
    using GoesOn = std::function<bool(int done, int cells)>;
    Checked<bool> run(const GoesOn& goesOn);

    const Image& image() const { return picture_.image(); }
    std::string csv() const { return sheetCsv(plan_, rows_); }

    /// Writes what there is, in the format that the file's name says.
    Result<void> write(const std::filesystem::path& file, AssetClient& client) const;

  private:
    Result<void> make(int column, int row, const CellMaker::Cancelled& isCancelled);
    void repeatStart(int column, int row);
    void refuse(CellRow cell, std::string why);

    const SheetPlan& plan_;
    Sheet sheet_;
    SheetForm form_;
    CellMaker& cells_;
    SheetPicture picture_;
    Image last_; ///< is the last cell that was drawn
    std::vector<CellRow> rows_;
};

} // namespace patina
