// SPDX-License-Identifier: GPL-3.0-or-later
// What people read of a chart of costs.
#pragma once

#include <QString>

#include "accuracy/way_delegate.h"
#include "measure/cost/cost_chart.h"
#include "measure/cost/sweep_step.h"
#include "text/display_number.h"

namespace patina {

/// The levels that are not exact.
std::vector<WayPart> wayParts(const CostPoint& point, const CostChart& chart);

/// "Render scale: Half + Fog: Per vertex"; "Exact" where every choice is.
QString wayName(const CostPoint& point, const CostChart& chart);

/// The same in full: which choice has which level, and what that means, line by line.
QString wayDescription(const CostPoint& point, const CostChart& chart);

/// "1.23 ± 0.02" of a ratio; "1.23 ± ?" where a busy machine left an
/// interval that says nothing.
QString ratioText(const MedianInterval& ratio);

/// The ratio of a cost in the same way; "< 0.02" and "> 3.5" of bounds, "–" where nothing is known
/// of it.
QString costRatioText(const ChoiceCost& cost, RatioBound bound);

/// Returns how sure that is.
QString ratioNote(const ChoiceCost& cost, RatioBound bound);

/// Nanoseconds per pixel, as sure as the ratio is; "< 12.3" of a bound. Without how sure they are
/// where that stands beside it.
QString perPixelText(const ChoiceCost& cost, bool withInterval);

/// The number of instructions ("–": not known), their kinds line by line, and a number to sort by.
QString countText(const std::optional<InstructionCount>& count);
QString kindsText(const std::optional<InstructionCount>& count);
double countOf(const std::optional<InstructionCount>& count);

/// Returns which other points cannot be told from this one, neither in time nor in error, and
/// whether only the noise keeps it from the front; empty: neither.
QString tieText(const CostPoint& point, const CostChart& chart, Standing standing);

/// Returns what the errors are against of points that are compared with the chart's converged
/// render.
QString convergedNote(const CostChart& chart);

/// The name and the numbers of the chart's point of that number, line by line.
QString pointText(std::size_t number, const CostChart& chart);

/// Returns what a measurement is doing, and how much of it is done.
QString stepText(const SweepStep& step, const CostChart& chart);

/// Returns what is said beside points that were measured before something changed.
QString staleText();

/// Returns how it was measured: pixels, timer, what errors are against.
QString methodText(const CostChart& chart);

/// Returns what else is to be known of it: what was left out, errors that are against something
/// else, levels without a point.
QString notesText(const CostChart& chart);

} // namespace patina
