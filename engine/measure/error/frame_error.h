// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "measure/error/display_curve.h"
#include "measure/error/flip.h"
#include "measure/error/linear_frame.h"
#include "measure/error/parallel_job.h"

namespace patina {

/// Holds the error of a frame against the ground truth, over the pixels that count. A pixel's
/// relative error is the largest error of its channels in linear light over the brightest channel
/// of the ground truth, or over the light of half an 8-bit step where that is brighter.
struct FrameError {
    double max = 0.0;
    double mean = 0.0;
    double rms = 0.0;
    double p99 = 0.0;       ///< is the relative error that 99 of 100 pixels keep
    double stepShare = 0.0; ///< is the share of pixels that are off by an 8-bit step or more
    double shown = 0.0;     ///< is the greatest difference of display values, 0 .. 1
    double flip = 0.0;      ///< is the mean FLIP difference, 0 .. 1; see flip.h
    std::size_t pixels = 0; ///< is the number of pixels that count

    friend bool operator==(const FrameError&, const FrameError&) = default;
};

/// Compares frames with a ground truth.
class ErrorMeter {
  public:
    ErrorMeter(LinearFrame groundTruth, const DisplayCurve& curve);

    /// Prepares the meter in `work`. Until that is done, this object must not move.
    ErrorMeter(LinearFrame groundTruth, const DisplayCurve& curve, ParallelJob& work);

    /// Compares a frame of the same size. The ground truth says which pixels count; others are
    /// taken for equal.
    FrameError errorOf(const LinearFrame& frame) const;

    /// Writes the error into `error` in `work`. Until that is done, the arguments and this object
    /// must not move.
    void addErrorOf(ParallelJob& work, const LinearFrame& frame, FrameError& error) const;

    /// Returns the relative error of each pixel, rows from the top; 0 where a pixel does not count.
    std::vector<double> mapOf(const LinearFrame& frame) const;

    const LinearFrame& groundTruth() const { return groundTruth_; }

  private:
    double relative(const LinearFrame& frame, std::size_t pixel) const;

    LinearFrame groundTruth_;
    DisplayCurve curve_;
    std::vector<glm::dvec3> shown_; ///< has the ground truth's display values
    double floor_ = 0.0;            ///< is the least light that errors are relative to
    std::optional<Flip> flip_;
};

} // namespace patina
