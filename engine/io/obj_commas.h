// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/error.h"

namespace patina {

/// Finds the first ambiguous comma in the coordinates of an OBJ file, and returns an error with its
/// line and column: "0,5,1" and "1,000.5" are ambiguous, and "0,5" in a file that has decimal
/// points as well. Returns nothing where every number is clear: "0,5 1,5" (decimal commas
/// throughout) and "1, 2, 3".
std::optional<Error> unclearComma(std::string_view text);

} // namespace patina
