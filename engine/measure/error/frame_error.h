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

/// Says how far a frame is from the ground truth, over the pixels that count. Relative errors are
/// those of a pixel's channel that is off by most, in linear light, relative to the pixel's
/// brightest channel; where that is too dark for half of an 8-bit step, relative to that.
struct FrameError {
    double max = 0.0;
    double mean = 0.0;
    double rms = 0.0;
    double p99 = 0.0;       ///< 99 of 100 pixels are off by no more
    double stepShare = 0.0; ///< of the pixels: shown at least one 8-bit step too bright or dark
    double shown = 0.0;     ///< the greatest difference on the display, 0 .. 1
    double flip = 0.0;      ///< mean perceptual difference, 0 .. 1; see flip.h
    std::size_t pixels = 0; ///< that count

    friend bool operator==(const FrameError&, const FrameError&) = default;
};

/// Compares frames with a ground truth.
class ErrorMeter {
  public:
    ErrorMeter(LinearFrame groundTruth, const DisplayCurve& curve);

    /// Makes the same, ready when `work` is done. Until then it must stay where it is.
    ErrorMeter(LinearFrame groundTruth, const DisplayCurve& curve, ParallelJob& work);

    /// `frame` is of the same size; its own counts say nothing, and its pixels that do not count
    /// are taken for right.
    FrameError errorOf(const LinearFrame& frame) const;

    /// Writes the same into `error`, by `work`. Until it is done all of them must stay where they
    /// are.
    void addErrorOf(ParallelJob& work, const LinearFrame& frame, FrameError& error) const;

    /// Returns the relative error of each pixel, rows from the top; 0 where nothing counts.
    std::vector<double> mapOf(const LinearFrame& frame) const;

    const LinearFrame& groundTruth() const { return groundTruth_; }

  private:
    double relative(const LinearFrame& frame, std::size_t pixel) const;

    LinearFrame groundTruth_;
    DisplayCurve curve_;
    std::vector<glm::dvec3> shown_; ///< the ground truth on the display
    double floor_ = 0.0;            ///< light that is taken for no darker
    std::optional<Flip> flip_;
};

} // namespace patina
