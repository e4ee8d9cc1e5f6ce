// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/block.h"
#include "core/error.h"

namespace patina {

/// Returns what a driver would blame on the text around a block's: the functions that its kind is
/// called by (docs/design/blocks.md lists them) and that it lacks, what it opens and does not
/// close, and directives that are the whole program's. `glsl` is the block's file without comments.
Errors blockTextMistakes(const Block& block, std::string_view glsl);

} // namespace patina
