// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "measure/error/converged_frame.h"
#include "measure/error/ground_truth_frame.h"

namespace patina {

/// Makes what the errors of a sweep are measured against: the ground truth and, where points differ
/// in their directions of an environment, a converged one. Made, used and destroyed with one
/// context current.
class ErrorStandard {
  public:
    /// `directions`: Choice::id of the points' choice of directions; empty where there is none.
    ErrorStandard(GroundTruthFrame::Wish wish, std::string directions);

    /// Works for about so long; true when all is done.
    Result<bool> step(std::chrono::milliseconds patience);
    bool isDone() const;
    std::size_t steps() const { return directions_.empty() ? 1 : 2; } ///< frames
    double progressOfStep() const; ///< 0 .. 1, of the frame that is made

    const GroundTruthFrame& groundTruth() const { return groundTruth_; }

    /// Describes the converged frame when it is done; nothing where points have the same
    /// directions.
    std::optional<ConvergedRender> converged() const;

    /// Returns what a point of these levels is compared by, when all is done.
    const ErrorMeter& meterOf(const ChosenLevels& levels) const;

  private:
    GroundTruthFrame::Wish wish_;
    std::string directions_;
    GroundTruthFrame groundTruth_;
    std::optional<ConvergedFrame> converged_; ///< from when the ground truth is done
};

} // namespace patina
