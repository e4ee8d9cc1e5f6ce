// SPDX-License-Identifier: GPL-3.0-or-later
// Writes charts of costs as text for people.
#pragma once

#include <QString>

#include "accuracy/setting_delegate.h"
#include "measure/cost/cost_chart.h"
#include "measure/cost/sweep_step.h"
#include "text/display_number.h"

namespace patina {

/// Returns the labels of a point's levels and their choices, without exact levels.
std::vector<SettingPart> settingParts(const CostPoint& point, const CostChart& chart);

/// Returns "Render scale: Half + Fog: Per vertex"; "Exact" if every choice is exact.
QString settingName(const CostPoint& point, const CostChart& chart);

/// Returns the labels of a point's choices and levels with what each level does, one per line.
QString settingDescription(const CostPoint& point, const CostChart& chart);

/// Returns "1.23 ± 0.02"; "1.23 ± ?" if the interval is too wide to say anything, as on a busy
/// machine.
QString ratioText(const MedianInterval& ratio);

/// Returns the ratio of a cost as ratioText() does; "< 0.02" and "> 3.5" for bounds, "–" if it is
/// unknown.
QString costRatioText(const ChoiceCost& cost, RatioBound bound);

/// Returns a sentence on how sure the ratio is.
QString ratioNote(const ChoiceCost& cost, RatioBound bound);

/// Returns nanoseconds per pixel; "< 12.3" for a bound. Appends the interval if `withInterval`,
/// which tables with a column of ratios do not need.
QString perPixelText(const ChoiceCost& cost, bool withInterval);

/// Return the number of instructions as text ("–" if unknown), the number of each kind, one per
/// line, and the total as a number to sort by (-1 if unknown).
QString countText(const std::optional<InstructionCount>& count);
QString kindsText(const std::optional<InstructionCount>& count);
double countOf(const std::optional<InstructionCount>& count);

/// Names the points that cannot be told from this one in time and in error, and says whether only
/// the noise keeps it off the front; empty if neither is so.
QString tieText(const CostPoint& point, const CostChart& chart, Standing standing);

/// Says what the errors are measured against for points that are compared with the chart's
/// converged render. The chart must have one.
QString convergedNote(const CostChart& chart);

/// Returns the name and the numbers of the chart's point of that index, one per line.
QString pointText(std::size_t number, const CostChart& chart);

/// Says what a measurement is doing, and how much of it is done.
QString stepText(const SweepStep& step, const CostChart& chart);

/// Says that a point's numbers were measured before a change.
QString staleText();

/// Says how the chart was measured: pixels, timer, reference of the errors.
QString methodText(const CostChart& chart);

/// Says what else matters: what was left out, which errors have another reference, which levels
/// have no point of their own.
QString notesText(const CostChart& chart);

} // namespace patina
