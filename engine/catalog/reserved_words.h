// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace patina {

/// Tells whether a word cannot name a field because GLSL (4.10 specification, section 3.6) or C++
/// has taken it. Only words that a parameter id can make are listed: letters and digits.
bool isReservedWord(std::string_view word);

} // namespace patina
