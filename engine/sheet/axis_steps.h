// SPDX-License-Identifier: GPL-3.0-or-later
// This file says what one step of an axis does to a scene, for each kind of axis.
#pragma once

#include "sheet/sheet_plan.h"

namespace patina {

/// Tells whether a parameter's value is one number, which may have a range.
bool isOneNumber(const Parameter& parameter);

/// Applies an entry of an axis to the scene and its object of this number. Returns an error where
/// the scene has no such thing; the scene may then be changed in part.
Result<void> applyStep(Scene& scene, std::size_t object, const SheetAxis& axis,
                       const std::string& entry, const Catalog& catalog);

/// Returns the axis with its title and steps and applies nothing. It is an error where the axis
/// names nothing that the scene has, or has a range although its value is no number.
Result<PlannedAxis> plannedAxis(const SheetAxis& axis, const Scene& scene, std::size_t object,
                                const Catalog& catalog);

} // namespace patina
