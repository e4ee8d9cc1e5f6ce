// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/block.h"

namespace patina {

/// An enum may be shorthand: choosing one of its values sets other parameters of the block (see
/// EnumValue::fills), and a choice without fills stands for values of one's own. The functions here
/// keep choice and values consistent: a spectrum sets the numbers of srgbWavelengths. Such an enum
/// never reaches a shader.

/// Tells whether any choice of the parameter sets other parameters.
bool isShorthand(const Parameter& parameter);

/// Returns every value that setting `parameter` to `wanted` decides: its own; for a shorthand all
/// that its choices may set; for a parameter that a shorthand sets, the shorthand, which changes to
/// its choice without fills unless all that it sets still agrees. Values that are missing count as
/// their defaults.
Values afterEdit(const Block& block, const Values& values, const Parameter& parameter,
                 const Value& wanted);

/// Returns the choice of a shorthand that sets parameters by spectra (see spectrum.h); null where
/// another one is taken, or the parameter is no shorthand. Allocates nothing.
const EnumValue* spectralChoice(const Parameter& parameter, const Values& values);

/// Adds what the given shorthands set and `given` does not have: a value that is given beside a
/// choice takes precedence.
void fillGaps(const Block& block, Values& given);

/// Changes each shorthand whose choice does not agree with the values to its choice without fills.
void settleShorthands(const Block& block, Values& values);

} // namespace patina
