// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "catalog/block.h"

namespace patina {

/// Returns the accuracy choices of blocks as enum parameters of one block, so that the one form and
/// the one command serve them, too; blocks share a choice of the same id.
Block accuracyBlock(std::span<const Block* const> blocks);

} // namespace patina
