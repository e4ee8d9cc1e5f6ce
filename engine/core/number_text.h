// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina {

/// Returns the shortest text that reads back as the same float, in the C locale ("0.1", "1e+20").
std::string shortestText(float value);

/// Returns the same for the float nearest to a double.
std::string shortestFloatText(double value);

/// Writes 17 significant digits, enough for every double, in the C locale.
std::string fullText(double value);

/// Reads a finite number in the C locale that is the whole text but for spaces and tabs around it.
/// Anything else ("nan", "inf", "1e999", "") gives no value.
std::optional<double> parseNumber(std::string_view text);

} // namespace patina
