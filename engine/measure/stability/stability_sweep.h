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
    bool gpu = true;   ///< needs a current OpenGL context while the sweep exists
    bool error = true; ///< compares the two where both are evaluated
    /// Is about the number of cases in all.
    std::size_t cases = 300000;
    /// Evaluates every edge case of each program, and 16 with each set of edge-case values, even
    /// where that exceeds `cases`. Otherwise an even part of them, a different one for each
    /// program.
    bool isWhole = true;
    std::size_t slice = 1u << 14;  ///< limits the cases of one step
    std::filesystem::path shaders; ///< is the folder with lib/ and passes/
};

/// Evaluates programs of blocks in edge-case directions and in ordinary ones with their own values,
/// and in some of both with every set of edge-case values. It checks each value before it is
/// clamped, and compares the graphics device with the double-precision code. A block without such
/// code, which was added after this program was built, has its claims tried on the device instead.
/// It works in steps, so that a caller can show progress and stop between them.
class StabilitySweep {
  public:
    /// Takes variants from sweepVariants() or sweepVariant(); their blocks must outlive the sweep.
    StabilitySweep(std::vector<EvalCase> variants, SweepOptions options);
    ~StabilitySweep();

    bool finished() const { return run_.isDone(); }

    /// Returns 0 .. 1.
    double progress() const;

    /// Returns how many cases it evaluates from beginning to end.
    std::size_t plannedCases() const;

    /// Returns how many edge cases and sets of values it leaves out; 0 where it is whole.
    std::size_t leftOut() const;

    /// Does one slice of the work, in which at most one program is compiled.
    void step() { run_.step(); }

    const SweepReport& report() const { return report_; }

    /// Says which block cannot be evaluated in double precision, and why; empty where all can.
    const std::string& withoutReference() const { return withoutReference_; }

  private:
    class Variant;
    struct Share;
    Share shareOf(std::size_t index) const;
    Steps run();

    std::vector<EvalCase> variants_;
    SweepOptions options_;
    std::size_t done_ = 0;             ///< counts variants that are done
    std::unique_ptr<Variant> current_; ///< is null between two of them
    SweepReport report_;
    std::string withoutReference_;
    Steps run_;
};

} // namespace patina
