// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/value.h"

namespace patina {

/// Gives the value of a parameter by id; nothing when there is no such parameter.
using ValueLookup = std::function<std::optional<Value>(std::string_view)>;

/// Evaluates a descriptor's `enabledWhen`: parameter names, numbers, true, false, ids of enum
/// values (bare or quoted), == != < <= > >=, and, or, not, parentheses. Nothing when the text does
/// not parse: the row then stays enabled, because hiding by mistake is worse than showing.
std::optional<bool> evaluateEnabled(std::string_view expression, const ValueLookup& lookup);

/// The words and signs of an expression in order, without blanks and quotes: to know which
/// parameters it depends on and to put it into plain words.
std::vector<std::string> tokensOf(std::string_view expression);

} // namespace patina
