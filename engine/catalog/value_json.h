// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "catalog/parameter.h"

namespace patina {

/// Reads the value that JSON holds for a parameter as it is written: not brought into range, not
/// rounded. The error says what would have been right; an unknown choice of an enum is such an
/// error and lists the choices.
ValueReading valueFromJson(const Parameter& parameter, const nlohmann::json& json);

/// Returns the first part of a value that was brought into its range; the whole where it has no
/// parts.
ValuePart broughtIn(const Value& given, const Value& inRange);

/// Returns the JSON of a value: a number, true or false, an array of numbers, a string, or for a
/// list of numbers what its type writes.
nlohmann::json toJson(const Value& value);

/// Returns a value as text that reads back: "0.5", "true", "ggx", "[0.8, 0.1, 0.1]", "0,0 0.5,0.7
/// 1,1".
std::string textOf(const Value& value);

} // namespace patina
