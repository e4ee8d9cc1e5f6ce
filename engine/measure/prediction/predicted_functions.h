// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "predict/family_compiler.h"

namespace patina {

/// Is a function of a program's fragment stage, and what the stage is without it: with a number in
/// place of what the function computes.
struct PredictedFunction {
    std::string name;
    int line = 0; ///< is that of its name in the stage's text, 1-based
    Result<FamilyStatistics> without;

    /// It is a block's own, or called by one: not one of the passes, without which nothing is left.
    bool isOfBlock = false;
};

struct PredictedFunctions {
    std::string driver;
    Result<FamilyStatistics> whole;
    std::vector<PredictedFunction> functions; ///< are in the order of the text

    /// Says how much less the stage takes on a family without one of the functions.
    struct Saving {
        int instructions = 0;
        int registers = 0; ///< vector registers
        double cycles = 0.0;
    };

    /// Returns nothing where the stage, or the stage without the function, was not compiled.
    std::optional<Saving> savingOf(const PredictedFunction& function,
                                   const std::string& family) const;

    /// Returns the function of a block without which the stage has the fewest registers, the last
    /// of several, which calls the others; null where none saves any.
    const PredictedFunction* widest(const std::string& family) const;
};

/// Predicts what each function of a program's fragment stage takes, together with what is called or
/// computed for it alone: functions of numbers and vectors, except main(). Nothing is drawn.
Result<PredictedFunctions> predictedFunctions(const ProgramText& program,
                                              std::span<const GpuFamily* const> families,
                                              const FamilyCompilerOptions& options = {});

} // namespace patina
