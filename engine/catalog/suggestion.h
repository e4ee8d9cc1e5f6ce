// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace patina {

/// Returns what the user may have meant by `word`: the nearest candidate when it is near enough (at
/// most a third of its letters differ), else "".
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// "one of a, b, c", or "'b' (or one of a, c)" when one of them is near to `word`.
std::string oneOf(std::string_view word, std::span<const std::string> candidates);

} // namespace patina
