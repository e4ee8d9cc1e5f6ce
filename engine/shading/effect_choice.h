// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "catalog/parameter_layout.h"
#include "material/material.h"
#include "scene/scene.h"

namespace patina {

/// The value a parameter has: the given one where it is there and of the right type, else the
/// default. Points into one of the arguments.
const Value& givenValue(const Parameter& parameter, const Values& values);

/// Index of the chosen enum value or accuracy level; 0 where the choice is not known.
std::size_t chosenIndex(const Parameter& parameter, const Values& values);
std::size_t chosenIndex(const AccuracyChoice& choice, const AccuracyLevels& levels);

/// True when the parameter is a number that is 0, or a vector or colour without a positive part.
bool isZero(const Parameter& parameter, const Values& values);

/// What a compiled parameter contributes to the program, as a small number: the enum value's
/// index, a bool, or whether a float is zero.
std::size_t compiledState(const Parameter& parameter, const Values& values);

/// Whether a light can send anything, and whether fog can hide anything.
bool canShine(const Light& light, const Block& block);
bool canHide(const BlockValues& fog, const Block& block);

/// The Fresnel block that works in the model's slot, or on the sum; see EffectSet.
bool hasFresnelSlot(const Block& model);

} // namespace patina
