// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "measure/eval/eval_case.h"

namespace patina {

/// Says how the largest error of a text is looked for.
struct ErrorClimb {
    std::size_t climbers = 24; ///< counts the cases that move
    std::size_t rounds = 20;   ///< counts how often each of them is tried in other places
    std::size_t tries = 6;     ///< counts the places of a round
    bool hasOwnValues = false; ///< the values of cases stay
};

/// Is where cases have come to, and the largest error there; infinite where a number is not safe.
struct WorstCases {
    std::vector<EvalCase> cases;
    double error = 0.0;
};

/// Returns how far off a way is in each of several cases; infinite where a number is not safe.
using CaseErrors = std::function<std::vector<double>(const std::vector<EvalCase>& cases)>;

/// Looks for the largest error of a way: begins with the worst of `from`, and moves each of them to
/// where the error is larger (nearbyCases()), for cases drawn at random rarely meet the place where
/// it is largest.
WorstCases worstCases(const CaseErrors& errorsOf, const std::vector<EvalCase>& from,
                      const ErrorClimb& how, const std::function<bool()>& isStopped);

} // namespace patina
