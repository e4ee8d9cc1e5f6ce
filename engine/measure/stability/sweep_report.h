// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <string_view>

#include "measure/eval/eval_case.h"
#include "measure/eval/reference_case.h"

namespace patina {

/// Tells what can be wrong with a value, and then with the values that a claim is about.
enum class Defect {
    NotANumber,
    Infinite,
    Negative,
    BelowHorizon,
    Inaccurate,
    NotReciprocal,
    NotIsotropic,
    NotConserving,
    NotContinuous,
    NotMonotonic
};

/// Returns "not a number", "negative", ...
const char* wordsFor(Defect defect);

/// Represents one value that is wrong.
struct SweepFinding {
    Defect defect = Defect::NotANumber;
    EvalCase request;         ///< with `gpu` set to where it went wrong
    ReferenceNumbers value{}; ///< what was returned, as many numbers as the block answers
    std::size_t numbers = 3;
    ReferenceNumbers exact{}; ///< in double precision, or by the claim; for a claim one number
    /// Is how bad: |error| over its bound for Inaccurate and claims, else the size of the number.
    double excess = 0.0;
};

/// Everything of one defect in one place.
struct SweepTally {
    std::size_t count = 0;
    SweepFinding worst;
};

/// Names what is counted as one: a defect of a function in one precision.
struct SweepKey {
    bool gpu = false; ///< on the graphics device
    Defect defect = Defect::NotANumber;
    std::string_view call{}; ///< the suffix of the function

    friend auto operator<=>(const SweepKey&, const SweepKey&) = default;
};

/// Holds what a sweep has found so far.
struct SweepReport {
    std::size_t cases = 0; ///< evaluated, on the CPU, the graphics device or both
    std::size_t programs = 0;
    double largestError = 0.0; ///< of |error| over its bound, or over as much of it as was enough
    std::map<SweepKey, SweepTally> defects;
    Errors errors;              ///< why a program could not be tried
    bool withoutDouble = false; ///< some program was tried on the graphics device only
    bool withoutDevice = false; ///< some program was tried in double precision only

    bool isClean() const { return defects.empty() && errors.empty(); }

    void add(const SweepFinding& finding);
    void add(const SweepReport& other);
};

} // namespace patina
