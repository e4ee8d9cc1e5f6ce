// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/steps.h"
#include "measure/stability/sweep_report.h"

namespace patina {

/// Says where a sweep evaluates, and how much of it.
struct SweepOptions {
    bool cpu = true;
    bool gpu = true;   ///< an OpenGL context must be current while the sweep exists
    bool error = true; ///< compare the two where both are evaluated
    /// Is roughly the number of all cases.
    std::size_t cases = 300000;
    /// Every edge case of each program, and 16 with each set of edge-case values, even where they
    /// are more. Otherwise an even part of them, another one for each program.
    bool isWhole = true;
    std::size_t slice = 1u << 14;  ///< cases of one step
    std::filesystem::path shaders; ///< the folder that holds lib/ and passes/
};

/// Evaluates programs of blocks in edge-case directions and in ordinary ones between with their own
/// values, and in some of both with every set of edge-case values; looks at each value before it is
/// cut or clamped, and holds the graphics device against the double-precision code. Where there is
/// none, for a block that came after this program was built, what the block claims is tried on the
/// device. Works in steps, so that a caller can show progress and stop between them.
class StabilitySweep {
  public:
    /// `variants` come from sweepVariants() or sweepVariant(); their blocks must outlive the sweep.
    StabilitySweep(std::vector<EvalCase> variants, SweepOptions options);
    ~StabilitySweep();

    bool finished() const { return run_.isDone(); }

    /// Goes from 0 to 1.
    double progress() const;

    /// Returns how many cases it evaluates from beginning to end.
    std::size_t plannedCases() const;

    /// Returns how many edge cases and sets of values it leaves out; 0 where it is whole.
    std::size_t leftOut() const;

    /// Does one slice of the work: compiles at most one program.
    void step() { run_.step(); }

    const SweepReport& report() const { return report_; }

    /// Returns the block whose code cannot be evaluated in double precision, and why; empty text
    /// when all can.
    const std::string& withoutReference() const { return withoutReference_; }

  private:
    class Variant;
    struct Share;
    Share shareOf(std::size_t index) const;
    Steps run();

    std::vector<EvalCase> variants_;
    SweepOptions options_;
    std::size_t done_ = 0;             ///< of the variants
    std::unique_ptr<Variant> current_; ///< null between two of them
    SweepReport report_;
    std::string withoutReference_;
    Steps run_;
};

} // namespace patina
