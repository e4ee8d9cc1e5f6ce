// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace patina {

/// Is a graphics card that one can buy, with what a prediction needs of it.
struct GraphicsCard {
    std::string name;
    int computeUnits = 0;   ///< counts the cores of a Mali
    double megahertz = 0.0; ///< is the game clock where the maker gives one, else the boost clock
    std::string source;     ///< says where both numbers are published
};

/// Is a generation of AMD's graphics hardware, or one of ARM's Mali cores.
struct GpuFamily {
    std::string id; ///< is what a command line calls it, such as "rdna2"
    std::string label;
    /// Are names that RADV has for a chip of it; older drivers know another one than newer ones.
    std::vector<std::string> chips;
    int simdsPerUnit = 0;            ///< counts the SIMD units of a compute unit; 1 of a Mali
    std::vector<GraphicsCard> cards; ///< are one or more
    bool isMali = false; ///< is compiled for by ARM's `malioc`, the others by Mesa's RADV

    /// Returns the cycles of a SIMD unit that 64 look-ups of a texel take, when all SIMD units of a
    /// compute unit share its four texture units: one look-up each in a clock. 0 of a Mali.
    double lookUpCycles() const { return isMali ? 0.0 : 16.0 * simdsPerUnit; }

    /// Returns the card that stands for all where none is named: the middle one, as they are listed
    /// from the slowest on.
    const GraphicsCard& middleCard() const { return cards.at((cards.size() - 1) / 2); }
};

/// Is one graphics card with the family that it belongs to.
struct CardOfFamily {
    const GpuFamily* family = nullptr;
    const GraphicsCard* card = nullptr;

    bool standsForFamily = false; ///< is GpuFamily::middleCard(), as the family alone was named

    /// Returns "Steam Deck (RDNA 2)".
    std::string text() const;
};

/// Is the number of pixels of 1920 x 1080, for which milliseconds are given.
inline constexpr double fullHdPixels = 1920.0 * 1080.0;

/// Names what a prediction leaves out, for users.
inline constexpr const char* leftOutOfPrediction =
    "memory and caches, the rasteriser, the vertex stage and all other passes";

/// Returns all families that costs are predicted for, the oldest first: AMD's, and behind them the
/// Mali cores that the `malioc` in PATH knows, which is asked the first time.
std::span<const GpuFamily> gpuFamilies();

/// Returns the families of a list such as "rdna2,gcn", in its order and each once. It is an error
/// where there is none of a name.
Result<std::vector<const GpuFamily*>> gpuFamiliesIn(std::string_view list);

/// Returns the cards of all families.
std::vector<CardOfFamily> graphicsCards();

/// Returns the card of a part of its name, such as "6600" or "steam deck", or the middle card of a
/// family, such as "RDNA 2" or "rdna2". It is an error where none has the name, or more than one.
Result<CardOfFamily> graphicsCardIn(std::string_view name);

/// Returns the milliseconds in which a card runs a fragment stage on each of `pixels`, when all its
/// compute units do nothing else: pixels / 64 waves of `cyclesPerWave64` on every SIMD unit.
double predictedMilliseconds(double cyclesPerWave64, double pixels, const GpuFamily& family,
                             const GraphicsCard& card);

} // namespace patina
