// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "measure/eval/eval_case.h"

namespace patina {

/// Returns the places where functions of a struct's fields break, all exact in float: every two
/// edge cases of two fields meet. Directions lie along the axes, next to them and at the cosines of
/// edgeCaseDirections() to each, the second of a struct along few of them.
std::vector<EvalPlace> edgeCaseFields(std::span<const ArgumentField> fields);

/// `count` places with any values, the same for every call.
std::vector<EvalPlace> ordinaryFields(std::span<const ArgumentField> fields, std::size_t count);

} // namespace patina
