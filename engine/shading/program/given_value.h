// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "catalog/block.h"
#include "catalog/parameter_layout.h"

namespace patina {

/// Returns the value of a parameter: the given one where there is one of the right type, else the
/// default. It refers to one of the arguments.
const Value& givenValue(const Parameter& parameter, const Values& values);

/// Tells whether no component of a number, a vec3 or a colour is above 0; false for other types.
bool notPositive(const Value& value);

/// Return the state of a value that can be compiled (an enum's index), or the index of the chosen
/// accuracy level; 0 where the level is not known.
std::size_t chosenIndex(const Parameter& parameter, const Values& values);
std::size_t chosenIndex(const AccuracyChoice& choice, const AccuracyLevels& levels);

/// Tells whether the value is a float that is 0.
bool isZero(const Parameter& parameter, const Values& values);

/// Returns what a compiled parameter contributes to the program, as a small number: the state of
/// its value, or 0 where a float is zero or equals the other one of its block, and 1 where not.
std::size_t compiledState(const Block& block, const Parameter& parameter, const Values& values);

} // namespace patina
