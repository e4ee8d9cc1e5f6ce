// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace patina {

/// Returns the number that a person typed: `.` or `,` as the decimal mark in any locale, + - * /
/// and parentheses, and a unit that converts to `unit` ("45deg", "500 nm" where the unit is "um",
/// "50%"). Returns nothing for anything else, and never NaN or infinity.
std::optional<double> evaluateNumber(std::string_view text, std::string_view unit);

} // namespace patina
