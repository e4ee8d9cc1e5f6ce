// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sheet/sheet_plan.h"

namespace patina {

/// Represents one cell of a sheet's table.
struct CellRow {
    int column = 0;
    int row = 0;
    CellNumbers numbers{};
    std::string problem{}; ///< why there is no picture; empty where there is one
};

/// Returns the cells as comma-separated values with a line of names: where each is, what its axes
/// are at, its numbers, and why there is none. Milliseconds, relative error, albedo.
std::string sheetCsv(const SheetPlan& plan, const std::vector<CellRow>& cells);

/// Returns "1.2 ms", "error 0.003", "albedo 0.82": a line for each of these kinds, empty where
/// there is no number.
std::vector<std::string> captionOf(const CellNumbers& numbers,
                                   const std::vector<CellNumber>& kinds);

} // namespace patina
