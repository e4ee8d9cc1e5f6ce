// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "catalog/parameter_layout.h"

namespace patina {

/// Returns what the block calls of a value that is a function; null where the field holds the
/// value.
const ShaderFunction* functionOf(const ParameterField& field);

/// "hatchingToneCurve": what a block calls of the field.
std::string functionOfField(const Block& block, const std::string& field);

/// "toneCurveLinear": the bool of the struct that says whether the function is the plain one; empty
/// where it never is.
std::string plainField(const ParameterField& field);

/// The function of a field that reads its numbers, in GLSL or as C++: `base`, which
/// PARAMETER_DATA uses, is the field and has the type given.
std::string functionText(const Block& block, const ParameterField& field, std::string_view base);

/// The function of a field that is known to be the plain one.
std::string plainFunction(const Block& block, const ParameterField& field);

} // namespace patina
