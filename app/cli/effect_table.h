// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "measure/cost/effect_cost.h"
#include "measure/prediction/predicted_effects.h"

namespace patina {

/// Says which object of a scene is shown.
struct ShownObject {
    std::string name;       ///< may be empty
    std::size_t number = 1; ///< counted from 1
    std::size_t count = 1;  ///< counts the scene's objects
};

/// Returns a text such as "Ball, object 1 of 3".
std::string objectText(const ShownObject& object);

/// Holds what `patina effects` prints: the effects of one object, and what they cost where that was
/// measured or predicted.
struct EffectTable {
    ShownObject object;
    std::vector<EffectRow> rows;
    std::optional<EffectCosts> costs;
    std::vector<const GpuFamily*> families{}; ///< are those that costs are predicted for
    std::optional<PredictedEffects> predicted{};
};

/// Returns the table as text: a line for each effect, then the total.
std::string tableText(const EffectTable& table);

nlohmann::json tableJson(const EffectTable& table);

} // namespace patina
