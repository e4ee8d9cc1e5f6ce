// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "measure/stability/sweep_report.h"

namespace patina {

/// Returns where a case is, in words: "light 0.57 degrees above the horizon, viewer along the
/// normal, ..."; of another function than the kind's first one with its name before: "Left: way 3".
std::string placeText(const EvalCase& request);

/// By how much a value is wrong: "gives (nan, 0, 0)", "gives 0.153, exactly 0.05, 3.2 times ...".
std::string amountText(const SweepFinding& finding);

/// Returns "on the graphics device" or "on the CPU in double precision".
const char* precisionText(bool gpu);

/// Returns what a verdict has to add where not everything was evaluated twice: " on the graphics
/// device only", " in double precision only", or nothing.
const char* limitText(const SweepReport& report);

/// Everything of a report; what is not finite is the text "nan", "inf" or "-inf".
nlohmann::json toJson(const SweepReport& report);

} // namespace patina
