// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalog/block.h"
#include "core/error.h"
#include "reference/reference.h"

namespace patina {

/// Returns the double-precision code of a block. It is an error where the block was added since the
/// program was built, or has other parameters now.
Result<const reference::Block*> compiledBlock(const Block& block);

} // namespace patina
