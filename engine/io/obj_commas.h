// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/error.h"

namespace patina {

/// The first comma in a coordinate of an OBJ file that may mean one thing or another, with its line
/// and column: "0,5,1" and "1,000.5", and "0,5" in a file that has decimal points as well. Nothing
/// where every number can be told: "0,5 1,5" (decimal commas throughout) and "1, 2, 3".
std::optional<Error> unclearComma(std::string_view text);

} // namespace patina
