// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "catalog/block.h"
#include "core/error.h"
#include "shading/glsl/tokens.h"

namespace patina {

/// Returns where the text of a block computes an entry of a table from more than the parameters
/// that the table names: its tables would not be updated when the others change.
Errors entryMistakes(const Block& block, std::span<const GlslToken> tokens);

} // namespace patina
