// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace patina {

/// Returns the number that stands for a text as long as the program runs: 0 for the empty one, and
/// 1, 2, ... for others in the order in which they came. Any thread may call it.
int numberOfText(std::string_view text);

/// Returns the text that numberOfText() gave the number; empty where it gave it to none.
std::string numberedText(int number);

} // namespace patina
