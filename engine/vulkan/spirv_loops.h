// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/error.h"

namespace patina {

/// Is a loop that counts up by a constant from a constant to a constant, as do all loops in it. It
/// may have a way out before.
struct CountedLoop {
    int rounds = 0;
    std::size_t bound = 0;           ///< is the word of the module that names its bound
    std::size_t constantEnd = 0;     ///< is the word behind the definition of that bound
    std::uint32_t type = 0;          ///< is the bound's type
    std::int64_t onceBound = 0;      ///< is the bound that would leave one round
    std::vector<std::size_t> around; ///< are places of the counted loops around it among all
    int othersAround = 0;            ///< counts the other loops around it
    std::size_t instructions = 0;    ///< counts those in it
};

/// Tells whether a module has loops at all.
bool hasLoops(std::span<const std::uint32_t> module);

/// Tells whether a module reads texels.
bool readsTexels(std::span<const std::uint32_t> module);

/// Returns a fragment stage in SPIR-V after the optimiser's passes: functions inlined, constants
/// followed to where they are used.
Result<std::vector<std::uint32_t>> optimisedSpirv(std::span<const std::uint32_t> module);

/// Returns the counted loops of an optimised module.
std::vector<CountedLoop> countedLoops(std::span<const std::uint32_t> module);

/// Returns the module with one round of each of these loops of it.
std::vector<std::uint32_t> withOneRound(std::span<const std::uint32_t> module,
                                        std::span<const CountedLoop> loops);

} // namespace patina
