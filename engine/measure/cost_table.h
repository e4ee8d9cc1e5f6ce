// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/cost_chart.h"
#include "measure/model_ranking.h"

namespace patina {

/// What `patina cost` prints about a chart, for people: the points on the front marked.
std::string costText(const CostChart& chart);

/// One line for each point, with a line of names before them; `name` goes in the first column.
std::string costCsv(const CostChart& chart, const std::string& name, bool withNames);

nlohmann::json costJson(const CostChart& chart);

/// The models in the order in which they are given; times are those of the catalogue's first model.
std::string rankingText(const std::vector<ModelCost>& costs);
nlohmann::json rankingJson(const std::vector<ModelCost>& costs);

} // namespace patina
