// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/document.h"
#include "sheet/sheet_plan.h"

namespace patina {

/// Brings a cell of a sheet into the document, as one undo step: its material onto the active side
/// of all objects that are edited, its lights and its picture into the scene. A cell of the control
/// row brings the start back. Returns false, and makes no step, where the cell cannot be made or
/// the document shows it already.
bool takeCell(Document& document, const SheetPlan& plan, int column, int row);

} // namespace patina
