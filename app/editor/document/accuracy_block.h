// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "catalog/block.h"

namespace patina {

/// Returns the accuracy choices of blocks as enum parameters of one block, so that the same form
/// and command serve them. Blocks share a choice of the same id; a choice without levels is left
/// out.
Block accuracyBlock(std::span<const Block* const> blocks);

} // namespace patina
