// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "measure/error/converged_frame.h"
#include "measure/error/ground_truth_frame.h"

namespace patina {

/// Makes the frames with which a sweep's points are compared: the ground truth, where points
/// differ in their directions of an environment a converged frame, and where they differ in their
/// picture passes the finished picture. It must be made, used and destroyed with the same context
/// current.
class ErrorBaseline {
  public:
    /// Takes as `directions` the Choice::id of the choice of directions, empty where there is none,
    /// and whether there are choices of passes.
    ErrorBaseline(GroundTruthFrame::Wish wish, std::string directions, bool hasPasses = false);

    /// Works for about so long, and returns true when all is done.
    Result<bool> step(std::chrono::milliseconds patience);
    bool isDone() const;
    std::size_t steps() const { return directions_.empty() ? 1 : 2; } ///< counts frames
    double progressOfStep() const; ///< 0 .. 1, of the current frame
    /// Tells whether the frames are done that the device draws with the finest levels.
    bool hasGroundTruth() const;

    const GroundTruthFrame& groundTruth() const { return groundTruth_; }

    /// Returns a description of the converged frame once it is done; nothing where all points have
    /// the same directions.
    std::optional<ConvergedRender> converged() const;

    /// Returns the meter for a point of these levels, once all is done.
    const ErrorMeter& meterOf(const ChosenLevels& levels) const;

  private:
    GroundTruthFrame::Wish wish_;
    std::string directions_;
    GroundTruthFrame groundTruth_;
    std::optional<GroundTruthFrame> finished_; ///< is absent without choices of passes
    std::optional<ConvergedFrame> converged_;  ///< exists once the ground truth is done
};

} // namespace patina
