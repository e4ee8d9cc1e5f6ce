// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "material/material.h"

namespace patina {

/// Returns the values of a block that its descriptor gives as defaults.
BlockValues defaultsOf(const Block& block);

/// Returns values of another block in place of `values`, which `before` describes, by the same
/// rules as a model swap: values with the same id carry over, the others are parked beside them.
/// Returns the defaults where there are no values.
BlockValues swappedBlock(const BlockValues* values, const Block* before, const Block& after);

} // namespace patina
