// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of block more: the program's table, replaced at linking by one with the row that
// CONTRIBUTING.md shows.
#include <array>
#include <vector>

#include "catalog/block_kind.h"

namespace patina {
namespace {

#include "kind"

std::vector<BlockKind> withAdded() {
    const auto shipped = shippedBlockKinds();
    std::vector<BlockKind> all(shipped.begin(), shipped.end());
    all.push_back(sheen);
    return all;
}

} // namespace

std::span<const BlockKind> blockKinds() {
    static const std::vector<BlockKind> all = withAdded();
    return all;
}

} // namespace patina
