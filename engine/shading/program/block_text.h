// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "catalog/block.h"
#include "core/error.h"

namespace patina {

/// Returns the mistakes in a block's text that a driver would report in the text around it:
/// functions that calls of its kind need (docs/design/blocks.md lists them) and that are missing,
/// brackets and conditionals without an end, and directives that only the whole program may have.
/// `glsl` is the block's file without comments.
Errors blockTextMistakes(const Block& block, std::string_view glsl);

} // namespace patina
