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

/// Holds some ways to compute one material.
struct PredictedPoints {
    std::string driver;
    std::vector<PredictedWay> ways;

    /// Returns the way with these levels; null where it was not compiled.
    const PredictedWay* find(const ChosenLevels& levels) const;
};

/// Predicts what these ways to compute the subject's material cost, in their order. Nothing is
/// drawn.
Checked<PredictedPoints> predictedPoints(const PredictedSubject& subject,
                                         std::span<const ChosenLevels> ways,
                                         std::span<const GpuFamily* const> families,
                                         const FamilyCompilerOptions& options = {});

/// Holds the ways of several subjects, in their order.
struct PredictedWays {
    std::string driver;
    std::vector<std::vector<PredictedWay>> subjects;
};

/// Says which levels of a material's choices are compiled.
enum class PredictedLevels {
    Each,   ///< none, each level by itself, and those that the material has
    Present ///< only those that the material has
};

/// Predicts what these ways to compute each subject's material cost. Nothing is drawn.
Checked<PredictedWays> predictedWays(std::span<const PredictedSubject> subjects,
                                     PredictedLevels levels,
                                     std::span<const GpuFamily* const> families,
                                     const FamilyCompilerOptions& options = {});

} // namespace patina
