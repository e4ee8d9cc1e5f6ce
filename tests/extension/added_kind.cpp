// SPDX-License-Identifier: GPL-3.0-or-later
// A kind of block more: the program's table, replaced at linking by one with another row.
#include <array>
#include <vector>

#include "catalog/block_kind.h"

namespace patina {
namespace {

constexpr std::array sheenFunctions{BlockFunction{"", "vec3", "Incidence", "i"},
                                    BlockFunction{"Share", "float"}};

constexpr BlockKind sheen{
    .folder = "sheen",
    .singular = "sheen",
    .plural = "sheens",
    .label = "Sheen",
    .word = "Sheen",
    .owner = BlockOwner::Material,
    .functions = sheenFunctions,
};

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
