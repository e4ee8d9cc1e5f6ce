// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "measure/cost/cost_chart.h"

namespace patina {

/// Returns what `patina cost` prints about a chart: a table in which the points on the front and
/// those that tie with one of them are marked.
std::string costText(const CostChart& chart);

/// Returns a line for each point, below a line of names where `withNames` is set; `name` is in the
/// first column.
std::string costCsv(const CostChart& chart, const std::string& name, bool withNames);

nlohmann::json costJson(const CostChart& chart);

/// Reads what costJson() wrote; bounds of too few runs become the median. It is an error where
/// something is missing or of another type.
Result<CostChart> costFromJson(const nlohmann::json& json);

/// Returns an interval of so many samples; its bounds are null where those are too few for one.
nlohmann::json intervalJson(const MedianInterval& interval, int samples);
/// Returns "<lower>,<upper>", or "," where the samples are too few for an interval.
std::string boundsCsv(const MedianInterval& interval, int samples);
/// Returns the counts by kind and their total; null where there are none.
nlohmann::json countJson(const std::optional<InstructionCount>& count);
/// Returns the total, or "-" where there is none.
std::string instructionsText(const std::optional<InstructionCount>& count);

/// Returns "0.512 (0.509 .. 0.514)?": a ratio with so many digits after the point and its
/// doubtOf().
/// "<" and ">" precede a bound, and "-" replaces a ratio that is not known.
std::string ratioText(const ChoiceCost& cost, RatioBound bound, int digits);
/// Returns the nanoseconds per pixel; "<" precedes a bound.
std::string nanosecondsText(const ChoiceCost& cost);
/// Returns '!' where there are too few runs for an interval, '?' where it is wider than wanted, and
/// ' ' otherwise.
char doubtOf(const ChoiceCost& cost);
/// Returns the legend of those signs, for a table of ratios to the time of `what`.
std::string signsText(std::string_view what);

/// Returns a text as a field of a CSV file: in quotation marks, those in it doubled (RFC 4180).
std::string csvText(std::string_view text);

} // namespace patina
