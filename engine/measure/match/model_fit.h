// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "measure/match/match_target.h"

namespace patina {

/// Says what a fit makes small: the root of the mean square over all directions and channels of the
/// difference of m and t, which are pi f cos(theta_l) of model and target.
enum class MatchError {
    Log,      ///< ln(1 + m) - ln(1 + t): a highlight does not hide the rest
    Relative, ///< (m - t) / (t + 0.01)
    Linear,   ///< m - t
    /// L*(m) - L*(t), CIE's lightness of a channel, from 0 for black to 1 for white, above which m
    /// and t count by their logarithm.
    Lightness
};

/// Returns the words of the errors, in the order above.
std::span<const std::string_view> matchErrorWords();

/// Returns the error of a word; nothing for another word.
std::optional<MatchError> matchErrorOf(std::string_view word);

struct FitOptions {
    MatchError error = MatchError::Log;
    std::size_t starts = 5; ///< counts the random sets of values that are improved
    /// Are the only parameters that may change, by id, those of the slot's block after its kind and
    /// a dot; the choices and the slot stay then. Empty: all may.
    std::vector<std::string> only{};
};

/// Holds a model with the values that match a target best.
struct ModelFit {
    EvalCase model;
    double error = 0.0;    ///< is the measure that FitOptions names
    double relative = 0.0; ///< is the root of sum (m - t)^2 / sum t^2
};

/// Finds the values of a model, and of what fills its slot, that match a target best: the model's
/// own and the best of some hundred random ones are improved by Levenberg and Marquardt's method
/// within the ranges of the parameters (Ceres Solver), then one choice after the other is changed,
/// and the block in the slot, as long as that brings it nearer. The result is the same at every
/// call. Fails where a block cannot be evaluated (ModelValues); when cancelled it returns what it
/// has.
Result<ModelFit> fittedModel(const EvalCase& model, const MatchTarget& target,
                             const FitOptions& options, const Catalog& catalog,
                             const Progress& progress);

} // namespace patina
