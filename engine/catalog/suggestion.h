// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace patina {

/// Returns what the user may have meant by `word`: the most similar candidate (at most a third of
/// the letters of `word` differ), else "".
std::string nearest(std::string_view word, std::span<const std::string> candidates);

/// Returns "one of a, b, c", or "'b', or one of a, b, c" when one of them is similar to `word`.
std::string oneOf(std::string_view word, std::span<const std::string> candidates);

} // namespace patina
