// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what a shader costs on graphics cards that are not here.
#pragma once

#include <QString>

#include "predict/compile_request.h"
#include "predict/gpu_family.h"

namespace patina {

/// Returns the cycles of a stage for 64 pixels; "–" where there are none of the family.
QString predictedCyclesText(const Result<FamilyStatistics>& statistics, const GpuFamily& family);

/// Returns the same as a number to sort by; -1 where there is none.
double predictedCycles(const Result<FamilyStatistics>& statistics, const GpuFamily& family);

/// Returns the other numbers and the milliseconds on the family's cards, one per line, and what is
/// left out of them; or why there are none, with what to install. Empty where nobody asked.
QString predictionNote(const Result<FamilyStatistics>& statistics, const GpuFamily& family);

/// Says what the column of cycles holds.
QString predictionHint(const GpuFamily& family);

} // namespace patina
