// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/block.h"
#include "material/material.h"

namespace patina {

/// Returns the parameter of a kind of transparency that says how many surfaces of each pixel it
/// puts in order, one after the other; null for one that mixes them all at once.
const Parameter* layersParameter(const Block& transparency);

/// Returns how many surfaces are put in order, 1 .. 64; 0 where all are mixed at once.
int layersOf(const BlockValues& transparency, const Block& block);

} // namespace patina
