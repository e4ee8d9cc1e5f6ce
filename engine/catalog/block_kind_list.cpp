// SPDX-License-Identifier: GPL-3.0-or-later
// This function is alone in its file: a program that has more kinds defines it itself, and the
// linker then leaves this one out.
#include "catalog/block_kind.h"

namespace patina {

std::span<const BlockKind> blockKinds() {
    return shippedBlockKinds();
}

} // namespace patina
