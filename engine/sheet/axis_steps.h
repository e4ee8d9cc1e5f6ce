// SPDX-License-Identifier: GPL-3.0-or-later
// What one step of an axis does to a scene, for each kind of axis.
#pragma once

#include <vector>

#include "sheet/sheet_plan.h"

namespace patina {

/// Tells whether a parameter's value is one number, which may have a range.
bool isOneNumber(const Parameter& parameter);

/// Brings an entry of an axis into the scene.
Result<void> applyStep(Scene& scene, std::size_t object, const SheetAxis& axis,
                       const std::string& entry, const Catalog& catalog);

/// Returns the axis with its title and steps; nothing is applied yet. An error where the axis is of
/// nothing that the scene has, or its range is of no number.
Result<PlannedAxis> plannedAxis(const SheetAxis& axis, const Scene& scene, std::size_t object,
                                const Catalog& catalog);

} // namespace patina
