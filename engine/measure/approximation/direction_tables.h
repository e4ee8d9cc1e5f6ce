// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "catalog/block.h"
#include "measure/approximation/cheap_moves.h"

namespace patina {

/// Returns moves that read a function of one direction from a table, wherever the block calls it:
/// what it is given varies only with one cosine, as n.l and its squared sine do, or with the
/// block's values. The names of their tables begin with number `first`.
std::vector<CheapMove> directionTables(const ObservedShader& shader, const Block& block,
                                       std::size_t first);

} // namespace patina
