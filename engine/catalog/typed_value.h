// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/parameter.h"
#include "core/error.h"

namespace patina {

/// Parses a value that a person typed for a parameter: "0.5", "true", an enum value's id,
/// "0.1,0.2,0.3" (a colour is linear) or "#ff8800" (sRGB), "ease" or "0,0 0.5,0.7 1,1" for a curve.
/// A value out of its range is an error, which says what would have been right.
Result<Value> valueFromText(const Parameter& parameter, std::string_view text);

} // namespace patina
