// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet/sheet_plan.h"

namespace patina {

/// Holds one cell of a sheet's table.
struct CellRow {
    int column = 0;
    int row = 0;
    CellNumbers numbers{};
    std::string problem{}; ///< says why there is no picture; empty where there is one
};

/// Returns the cells as comma-separated values below a line of names: column and row from 1, the
/// entries of both axes, milliseconds, relative error, albedo, and why there is no picture.
std::string sheetCsv(const SheetPlan& plan, const std::vector<CellRow>& cells);

/// Returns a line for each of these kinds, as "1.2 ms", "error 0.003" or "albedo 0.82"; a line is
/// empty where there is no number.
std::vector<std::string> captionOf(const CellNumbers& numbers,
                                   const std::vector<CellNumber>& kinds);

} // namespace patina
