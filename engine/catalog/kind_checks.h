// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "catalog/block_kind.h"

namespace patina {

/// Returns what is wrong with a row of the table of kinds, or an empty text. The double-precision
/// code and `patina eval` can call only one function of `Directions`, the one without a suffix, and
/// no argument may have the key of a kind.
std::string kindMistake(const BlockKind& kind);

} // namespace patina
