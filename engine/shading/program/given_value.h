// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "catalog/block.h"
#include "catalog/parameter_layout.h"

namespace patina {

/// The value a parameter has: the given one where it is there and of the right type, else the
/// default. Points into one of the arguments.
const Value& givenValue(const Parameter& parameter, const Values& values);

/// Tells whether no part of a number, a vector or a colour is above 0.
bool notPositive(const Value& value);

/// The state of a value that can be compiled: an enum's index. Index of the chosen accuracy level;
/// 0 where the choice is not known.
std::size_t chosenIndex(const Parameter& parameter, const Values& values);
std::size_t chosenIndex(const AccuracyChoice& choice, const AccuracyLevels& levels);

/// True when the parameter is a number that is 0, or a vector or colour without a positive part.
bool isZero(const Parameter& parameter, const Values& values);

/// Returns what a compiled parameter contributes to the program, as a small number: the state of
/// its value, or whether a float is zero or the same as another one of its block.
std::size_t compiledState(const Block& block, const Parameter& parameter, const Values& values);

} // namespace patina
