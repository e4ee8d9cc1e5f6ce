// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "catalog/parameter.h"

namespace patina {

/// Returns the values of a parameter at which formulas break, each once, within its range and exact
/// in float, and the default first: both ends of the range and of the slider and the smallest steps
/// above them, 0, and the usual critical widths, exponents and indices that the range has (1e-4,
/// 1e-3, 0.05, 1, 1 + 1e-6, 1.5, 10, 100, 1000, 100 000). Vectors hold these alone and mixed; an
/// enum and a bool hold each choice.
std::vector<Value> edgeCaseValues(const Parameter& parameter);

} // namespace patina
