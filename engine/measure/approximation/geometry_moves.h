// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "measure/approximation/cheap_moves.h"

namespace patina {

/// Returns moves that take a number of `Directions` or `Incidence` from rounded cosines, as
/// 1 - (n.l)^2 for the squared sine, wherever the block reads it: it keeps fewer digits of small
/// angles.
std::vector<CheapMove> geometryMoves(const ObservedShader& shader);

} // namespace patina
