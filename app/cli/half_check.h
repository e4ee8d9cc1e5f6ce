// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "measure/approximation/half_terms.h"

namespace patina {

/// Returns which lines of a block survive floats of 16 bits and which break, as a table.
std::string halfText(const HalfReport& report, const std::string& name);

nlohmann::json halfJson(const HalfReport& report, const std::string& name);

} // namespace patina
