// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "measure/cost/cost_chart.h"

namespace patina {

/// Returns what `patina cost` prints about a chart, for people: the points on the front and those
/// that tie with one of them marked.
std::string costText(const CostChart& chart);

/// Returns one line for each point, with a line of names before them; `name` goes in the first
/// column.
std::string costCsv(const CostChart& chart, const std::string& name, bool withNames);

nlohmann::json costJson(const CostChart& chart);

/// Returns what costJson() wrote, to the precision of floats; bounds of too few runs are the
/// median. An error where something is missing or of another type.
Result<CostChart> costFromJson(const nlohmann::json& json);

/// Returns what tables of measurements have in common: an interval of so many samples, whose bounds
/// are null or left empty where those are too few for one, and a count, null where there is none.
nlohmann::json intervalJson(const MedianInterval& interval, int samples);
std::string boundsCsv(const MedianInterval& interval, int samples); ///< "<lower>,<upper>" or ","
nlohmann::json countJson(const std::optional<InstructionCount>& count);
std::string instructionsText(const std::optional<InstructionCount>& count); ///< or "-"

/// Returns "0.512 (0.509 .. 0.514)?": a ratio with so many digits after the point and what is to be
/// doubted of it; "<" and ">" before a bound, "-" where nothing is known of it.
std::string ratioText(const ChoiceCost& cost, RatioBound bound, int digits);
/// Returns nanoseconds per pixel; "<" before a bound.
std::string nanosecondsText(const ChoiceCost& cost);
/// Returns '!' for too few runs for an interval, '?': it is wider than was wanted, ' '.
char doubtOf(const ChoiceCost& cost);
/// Stands below a table with such ratios to the time of `what`.
std::string signsText(std::string_view what);

/// Writes a text as a field of a CSV file: in quotation marks, those in it doubled (RFC 4180).
std::string csvText(std::string_view text);

} // namespace patina
