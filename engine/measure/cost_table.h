// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/cost_chart.h"

namespace patina {

/// What `patina cost` prints about a chart, for people: the points on the front marked.
std::string costText(const CostChart& chart);

/// One line for each point, with a line of names before them; `name` goes in the first column.
std::string costCsv(const CostChart& chart, const std::string& name, bool withNames);

nlohmann::json costJson(const CostChart& chart);

/// What tables of measurements have in common: an interval, and a count, null where there is none.
nlohmann::json intervalJson(const MedianInterval& interval);
nlohmann::json countJson(const std::optional<InstructionCount>& count);
std::string instructionsText(const std::optional<InstructionCount>& count); ///< or "-"

/// A text as a field of comma-separated values: in quotation marks, those in it doubled (RFC 4180).
std::string csvText(std::string_view text);

} // namespace patina
