// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/error.h"

namespace patina {

/// Is a loop that counts by one from a constant to a constant, with no loop in it or around it.
struct CountedLoop {
    int rounds = 0;
    std::vector<std::uint32_t> once; ///< is the whole module, but with one round of this loop
};

/// Tells whether a module has loops at all.
bool hasLoops(std::span<const std::uint32_t> module);

/// Returns a fragment stage in SPIR-V after the optimiser's passes: functions inlined, constants
/// followed to where they are used.
Result<std::vector<std::uint32_t>> optimisedSpirv(std::span<const std::uint32_t> module);

/// Returns the counted loops of an optimised module.
std::vector<CountedLoop> countedLoops(std::span<const std::uint32_t> module);

} // namespace patina
