// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/cost/model_ranking.h"

namespace patina {

/// Return the models in the given order: as a table with a legend for users, as CSV with a line of
/// names, and as JSON.
std::string rankingText(const std::vector<ModelCost>& costs);
std::string rankingCsv(const std::vector<ModelCost>& costs);
nlohmann::json rankingJson(const std::vector<ModelCost>& costs);

} // namespace patina
