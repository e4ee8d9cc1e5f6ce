// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <string_view>

#include "measure/eval/eval_case.h"
#include "measure/eval/reference_case.h"

namespace patina {

/// Tells what is wrong with a value, or, from NotReciprocal on, which claim several values break.
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

/// Describes one value that is wrong.
struct SweepFinding {
    Defect defect = Defect::NotANumber;
    EvalCase request;         ///< has `gpu` set where the device's value is wrong
    ReferenceNumbers value{}; ///< is what was returned; the first `numbers` are used
    std::size_t numbers = 3;
    ReferenceNumbers exact{}; ///< is in double precision; for a claim the first is its limit
    /// Is |error| over its bound for Inaccurate and claims, else the size of the number.
    double excess = 0.0;
};

/// Counts the findings of one SweepKey and holds the worst.
struct SweepTally {
    std::size_t count = 0;
    SweepFinding worst;
};

/// Names what is counted together: a defect of a function in one precision.
struct SweepKey {
    bool gpu = false; ///< says that it is the graphics device's
    Defect defect = Defect::NotANumber;
    std::string_view call{}; ///< is the suffix of the function

    friend auto operator<=>(const SweepKey&, const SweepKey&) = default;
};

/// Holds what a sweep has found so far.
struct SweepReport {
    std::size_t cases = 0; ///< counts those evaluated, on the CPU, the device or both
    std::size_t programs = 0;
    double largestError = 0.0; ///< is |error| over its bound (ErrorBound::excess())
    std::map<SweepKey, SweepTally> defects;
    Errors errors;              ///< say why a program could not be tried
    bool withoutDouble = false; ///< says that a program was tried on the device only
    bool withoutDevice = false; ///< says that a program was tried on the CPU only

    bool isClean() const { return defects.empty() && errors.empty(); }

    void add(const SweepFinding& finding);
    void add(const SweepReport& other);
};

} // namespace patina
