// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "measure/stability/sweep_report.h"

namespace patina {

/// Some places, and what their values must keep with one set of values of a block.
struct ClaimTrial {
    Defect defect = Defect::NotReciprocal; ///< what it is when they do not
    bool brightest = false;                ///< with every colour of the block at its largest
    std::vector<EvalPlace> places;

    /// Holds what shows the claim to be false: the place, its value and what that had to be or not
    /// to exceed.
    struct Broken {
        std::size_t place = 0;
        double value = 0.0;
        double limit = 0.0;
        double excess = 0.0; ///< how far beyond, relative to what is allowed for
    };

    /// Judges the first number of each place's values.
    std::function<std::optional<Broken>(std::span<const double>)> judge;
};

/// Returns what a block claims beyond what single values show, tried: that light and viewer can be
/// exchanged, that turning both changes nothing, that no more light comes back than arrives, that
/// nothing is cut off at the horizon, that a reflectance rises towards grazing light. Empty where a
/// claim is about the block without what fills its slot.
std::vector<ClaimTrial> claimTrials(const EvalCase& variant);

/// Returns the case with every colour of the block and of what fills its slot at its largest.
EvalCase brightest(EvalCase request);

} // namespace patina
