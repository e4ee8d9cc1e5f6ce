// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "measure/stability/sweep_report.h"

namespace patina {

/// Holds some places and the claim that the values there must keep.
struct ClaimTrial {
    Defect defect = Defect::NotReciprocal; ///< is what to report when they do not
    bool brightest = false;                ///< asks for every colour of the block at its largest
    std::vector<EvalPlace> places;

    /// Holds the proof that the claim is false: the place, its value, and the value that it had to
    /// equal or not to exceed.
    struct Broken {
        std::size_t place = 0;
        double value = 0.0;
        double limit = 0.0;
        double excess = 0.0; ///< is the difference over the tolerance
    };

    /// Judges the first number of each place's values; nothing is returned where the claim holds.
    std::function<std::optional<Broken>(std::span<const double>)> judge;
};

/// Returns the trials of those claims of a block that single values cannot refute: that light and
/// viewer can be exchanged, that turning both changes nothing, that no more light is reflected than
/// arrives, that nothing is cut off at the horizon, that a reflectance rises towards grazing light.
/// Empty where something fills an optional slot, since the claims are about the block without it.
std::vector<ClaimTrial> claimTrials(const EvalCase& variant);

/// Returns the case with every colour of the block and of what fills its slot at its largest.
EvalCase brightest(EvalCase request);

} // namespace patina
