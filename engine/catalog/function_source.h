// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "catalog/parameter_layout.h"

namespace patina {

/// Describes the function that the block calls for a value that is a function; null where the field
/// holds the value itself.
const ShaderFunction* functionOf(const ParameterField& field);

/// Returns the name of the function that a block calls for the field: "hatchingToneCurve".
std::string functionOfField(const Block& block, const std::string& field);

/// Returns the name of the struct's bool that says whether the function is the plain one:
/// "toneCurveLinear"; empty where the type has no plain function.
std::string plainField(const ParameterField& field);

/// Returns the function of a field that reads its numbers, in GLSL or as C++: `base`, which
/// PARAMETER_DATA uses, is the type of the field.
std::string functionText(const Block& block, const ParameterField& field, std::string_view base);

/// Returns the function of a field that is known to be the plain one.
std::string plainFunction(const Block& block, const ParameterField& field);

} // namespace patina
