// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "measure/stability/sweep_report.h"

namespace patina {

/// Checks the values of one variant's cases for what no correct block returns.
class ValueChecks {
  public:
    explicit ValueChecks(const EvalCase& variant);

    /// Returns the worst defect of a case's numbers: not a number, infinite, negative, or not 0
    /// below the horizon where the block claims that. `excess` gets the size of the wrong number.
    std::optional<Defect> check(const EvalPlace& place, std::span<const double> numbers,
                                double& excess) const;

    /// Returns how many numbers the block's function returns.
    std::size_t numbers() const { return numbers_; }

  private:
    bool belowHorizon(const EvalPlace& place) const;

    std::size_t numbers_ = 3;
    std::size_t signed_ = 0; ///< counts the first ones, which may be below 0
    bool darkBelow_ = false; ///< says whether the block claims that
};

} // namespace patina
