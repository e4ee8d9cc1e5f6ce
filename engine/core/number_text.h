// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace patina {

/// The shortest text that reads back as the same float; always the C locale ("0.1", "1e+20").
std::string shortestText(float value);

/// Returns the same for the float next to a double.
std::string shortestFloatText(double value);

/// Writes 17 significant digits, enough for every double; always the C locale.
std::string fullText(double value);

/// A finite number, whole text, C locale; leading and trailing blanks allowed. Nothing else:
/// "nan", "inf", "1e999" and "" give no value.
std::optional<double> parseNumber(std::string_view text);

} // namespace patina
