// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "measure/stability/sweep_report.h"

namespace patina {

/// Looks at the values of one variant's cases for what no correct block gives.
class ValueChecks {
  public:
    explicit ValueChecks(const EvalCase& variant);

    /// Returns the worst that is wrong with the numbers of a case: not a number, infinite,
    /// negative, or not 0 below the horizon where the block claims that. `excess` gets the size of
    /// the wrong number.
    std::optional<Defect> check(const EvalPlace& place, std::span<const double> numbers,
                                double& excess) const;

    /// Returns how many numbers the block answers.
    std::size_t numbers() const { return numbers_; }

  private:
    bool belowHorizon(const EvalPlace& place) const;

    std::size_t numbers_ = 3;
    std::size_t signed_ = 0; ///< so many of the first may be below 0
    bool darkBelow_ = false; ///< whether the block claims to be
};

} // namespace patina
