// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

/// Returns a number as a form shows it: about four significant digits, no trailing zeros, `.` as
/// the decimal mark. `decimals` is how many places the parameter asks for; small numbers get more,
/// so that three digits always count.
std::string shownNumber(double value, int decimals);

/// Returns a unit as people write it: "deg" is a degree sign, "1/m2" has its exponent raised.
std::string shownUnit(std::string_view unit);

} // namespace patina
