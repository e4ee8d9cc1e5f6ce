// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "catalog/parameter.h"
#include "core/error.h"

namespace patina {

/// The value that JSON holds for a parameter, as it is written: not brought into range, not
/// rounded. The error (without a place) says what would have been right; an unknown choice of an
/// enum is such an error and lists the choices.
Result<Value> valueFromJson(const Parameter& parameter, const nlohmann::json& json);

/// The JSON of a value: a number, true or false, an array of numbers, a string.
nlohmann::json toJson(const Value& value);

} // namespace patina
