// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/cost/model_ranking.h"

namespace patina {

/// The models in the order in which they are given: for people, as lines with a line of names
/// before them, and for programs.
std::string rankingText(const std::vector<ModelCost>& costs);
std::string rankingCsv(const std::vector<ModelCost>& costs);
nlohmann::json rankingJson(const std::vector<ModelCost>& costs);

} // namespace patina
