// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace patina {

/// A number as a form shows it: about four significant digits, no trailing zeros, `.` as the
/// decimal mark. `decimals` is how many places the parameter asks for; small numbers get more, so
/// that three digits always count.
std::string shownNumber(double value, int decimals);

} // namespace patina
