// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "measure/choice/choices.h"
#include "measure/prediction/predicted_subject.h"

namespace patina {

/// Holds what one way to compute a material is on each family.
struct PredictedWay {
    ChosenLevels levels; ///< are those that are not exact
    Result<FamilyStatistics> statistics;
};

/// Holds the ways of several subjects, in their order.
struct PredictedWays {
    std::string driver;
    std::vector<std::vector<PredictedWay>> subjects;
};

/// Predicts what each subject's material costs when it is exact, then with each level of each of
/// its choices by itself, then with the levels that it has, where these are others. Nothing is
/// drawn.
Checked<PredictedWays> predictedWays(std::span<const PredictedSubject> subjects,
                                     std::span<const GpuFamily* const> families,
                                     const FamilyCompilerOptions& options = {});

} // namespace patina
