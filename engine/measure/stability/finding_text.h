// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "measure/stability/sweep_report.h"

namespace patina {

/// Returns a case's arguments in words: "light 0.57 degrees above the horizon, viewer along the
/// normal, ...". The suffix of another function than the kind's first one precedes them: "Left: way
/// 3".
std::string placeText(const EvalCase& request);

/// Says how wrong a value is: "gives (nan, 0, 0)", "gives 0.153, exactly 0.05: 3.2 times ...".
std::string amountText(const SweepFinding& finding);

/// Returns "on the graphics device" or "on the CPU in double precision".
const char* precisionText(bool gpu);

/// Returns what to add to a verdict where not everything was evaluated by both: " on the graphics
/// device only", " in double precision only", or an empty text.
const char* limitText(const SweepReport& report);

/// Returns the whole report; a number that is not finite is the text "nan", "inf" or "-inf".
nlohmann::json toJson(const SweepReport& report);

} // namespace patina
