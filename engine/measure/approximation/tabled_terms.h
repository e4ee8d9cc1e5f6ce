// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "catalog/block.h"
#include "measure/approximation/cheap_moves.h"

namespace patina {

/// Returns moves that read a term from a table of the block in place of computing it: one that
/// depends on two numbers of a pixel at most, and else on the block's values. The statements that
/// lead to the term go into the function that computes an entry, loops and branches included. None
/// where blocks of its kind have no tables.
std::vector<CheapMove> tabledTerms(const ObservedShader& shader, const Block& block);

} // namespace patina
