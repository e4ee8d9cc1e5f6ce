// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/effect_cost.h"

namespace patina {

/// What `patina effects` prints: the effects of one object, and what they cost where that was
/// measured.
struct EffectTable {
    std::vector<EffectRow> rows;
    std::optional<EffectCosts> costs;
};

/// For people: a line for each effect, then the total.
std::string tableText(const EffectTable& table);

nlohmann::json tableJson(const EffectTable& table);

} // namespace patina
