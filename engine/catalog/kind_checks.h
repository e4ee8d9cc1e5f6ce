// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/block_kind.h"

namespace patina {

/// Returns what a row of the table of kinds asks for that nothing can give: the double-precision
/// code and `patina eval` call one function of `Directions`, that without a suffix. Empty: nothing.
std::string kindMistake(const BlockKind& kind);

} // namespace patina
