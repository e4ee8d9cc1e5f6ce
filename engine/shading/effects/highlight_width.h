// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/block.h"

namespace patina {

/// Tells whether the block has a parameter that says how wide its highlight is
/// (Parameter::highlight).
bool hasHighlightWidth(const Block& block);

/// Statements that widen each of them in the struct `variable` by the float `spread` (see
/// passes/widened_highlight.glsl).
std::string widenedSource(const Block& block, const std::string& variable);

} // namespace patina
