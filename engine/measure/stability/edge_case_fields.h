// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "measure/eval/eval_case.h"

namespace patina {

/// Returns the places where functions of a struct's fields break, all exact in float, such that
/// every two edge cases of two fields meet. Directions lie along the y and z axes, next to them and
/// at many cosines to each. A normal has only few directions, on the side of the direction before
/// it.
std::vector<EvalPlace> edgeCaseFields(std::span<const ArgumentField> fields);

/// Returns the largest number that a field has in ordinary places.
double ordinaryMax(const ArgumentField& field);

/// Returns `count` places with ordinary values, the same for every call.
std::vector<EvalPlace> ordinaryFields(std::span<const ArgumentField> fields, std::size_t count);

} // namespace patina
