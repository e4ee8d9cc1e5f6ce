// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "measure/cost_chart.h"
#include "measure/sliced_capture.h"

namespace patina {

/// A frame whose light of an environment is a mean over as many directions as the finest frame has,
/// none of which that one or any coarser one draws. It is the mean of two halves that have nothing
/// to do with each other, which says how far it can be trusted. Made in steps, with one context
/// current.
class ConvergedFrame {
  public:
    /// What is wanted. All that is referred to must stay.
    struct Wish {
        Renderer& renderer;
        const MeshSource& meshes;
        ChosenFrame finest;      ///< as it is captured
        const LinearFrame& drawn; ///< the finest frame, with its counts
    };
    explicit ConvergedFrame(Wish wish);

    /// Works for about so long; true when all is done.
    Result<bool> step(std::chrono::milliseconds patience);
    bool isDone() const { return stage_ == Stage::Done; }
    double progress() const; ///< 0 .. 1

    const ErrorMeter& meter() const { return *meter_; } ///< of what is done
    int directions() const { return 2 * half_; }        ///< per pixel
    const FrameError& noise() const { return noise_; }  ///< of one half against the mean
    const FrameError& finest() const { return finest_; } ///< of the finest frame

  private:
    enum class Stage { First, Second, Preparing, Comparing, Done };

    void begin(int series);
    Result<void> takeHalf();
    void join(LinearFrame second);

    Wish wish_;
    int half_ = 0; ///< directions
    Stage stage_ = Stage::First;
    std::optional<SlicedCapture> capture_;
    LinearFrame first_;
    PieceWork work_;
    std::optional<ErrorMeter> meter_;
    FrameError noise_;
    FrameError finest_;
};

} // namespace patina
