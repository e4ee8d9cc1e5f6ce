// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/steps.h"
#include "measure/eval/eval_program.h"
#include "measure/stability/claim_trials.h"

namespace patina {

/// Tries a block's claims in one of its programs on the graphics device, with the variant's own
/// values and with a few that sliders reach. It is for blocks of users, whose claims no test has
/// tried.
class ClaimSweep {
  public:
    explicit ClaimSweep(const EvalCase& variant);

    double progress() const;

    /// Tries some of the claims in each step; the program's context must be current. Where drawing
    /// fails, `done` says why, and nothing more is tried.
    Steps run(const EvalProgram& program, SweepReport& report, Result<void>& done);

  private:
    std::vector<const ClaimTrial*> nextTrials();
    Result<void> tryOut(const std::vector<const ClaimTrial*>& trials, const EvalProgram& program,
                        SweepReport& report) const;
    EvalCase caseOf(const ClaimTrial& trial, std::size_t place) const;
    void judge(const ClaimTrial& trial, std::span<const double> values, SweepReport& report) const;

    std::vector<ClaimTrial> trials_;
    std::vector<EvalCase> rows_; ///< are sets of values; empty where nothing is to be tried
    std::size_t row_ = 0;
    std::size_t trial_ = 0;
};

} // namespace patina
