// SPDX-License-Identifier: GPL-3.0-or-later
// Alone in its file: a program that has more kinds defines this function itself, and the linker
// then leaves this one out.
#include "catalog/block_kind.h"

namespace patina {

std::span<const BlockKind> blockKinds() {
    return shippedBlockKinds();
}

} // namespace patina
